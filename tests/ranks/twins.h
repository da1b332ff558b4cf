/// @file
/// A world over all ranks and the same world in one engine, which every rank has whole.
#pragma once

#include <mpi.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "cellsweep/broadphase.h"
#include "cellsweep/ranks.h"

namespace cellsweep::ranks {

/// Of MPI_COMM_WORLD.
int own_rank();
int all_ranks();

/// True when it is on all ranks, so that none leaves a test that the others are in.
bool on_all_ranks(bool here);

/// How far names are apart: most of them are beyond 32 bits unless a test wants small ones.
inline constexpr GlobalId kFarApart = 0x300000007ULL;
inline GlobalId apart = kFarApart;

/// A name, in the order of the small numbers that the engine knows.
inline GlobalId global_id(BodyId body) {
  return body * apart + 5;
}
inline BodyId small_id(GlobalId id) {
  return static_cast<BodyId>((id - 5) / apart);
}

/// Every rank makes the same calls; each is made to the distributed world on the rank `giver` alone.
class Twins {
 public:
  explicit Twins(const RankOptions& options = {});

  DistributedBroadphase& world() { return *world_; }
  Broadphase& whole() { return whole_; }

  void insert(int giver, std::span<const BodyId> ids, std::span<const Aabb> boxes,
              std::span<const BodyFilter> filters = {});
  void move(int giver, std::span<const BodyId> ids, std::span<const Aabb> boxes);
  void set_filters(int giver, std::span<const BodyId> ids, std::span<const BodyFilter> filters);
  void remove(int giver, std::span<const BodyId> ids);

  /// Updates both and compares pairs, changes, owners and boxes; what differs, in words, the same on all
  /// ranks.
  std::string update_and_compare();
  /// What differs now.
  std::string compare(const PairChanges& truth, const RankChanges& said) const;
  std::string compare_pairs() const;

 private:
  std::string compare_bodies() const;

  Result<DistributedBroadphase> world_;
  Broadphase whole_;
};

}  // namespace cellsweep::ranks
