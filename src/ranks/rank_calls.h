/// @file
/// The calls of one rank between two updates: checked as far as it can see, and remembered.
#pragma once

#include <span>
#include <vector>

#include "cellsweep/broadphase.h"
#include "cellsweep/ranks.h"
#include "ranks/region.h"
#include "ranks/round.h"

namespace cellsweep::ranks {

/// A call is checked whole before anything is remembered. What throws std::bad_alloc has changed nothing.
class RankCalls {
 public:
  RankCalls(World& world, Broadphase& engine) : world_(world), engine_(engine) {}

  Status insert(std::span<const GlobalId> ids, std::span<const Aabb> boxes,
                std::span<const BodyFilter> filters);
  /// `region` is this rank's.
  Status move(const Region& region, std::span<const GlobalId> ids, std::span<const Aabb> boxes);
  Status set_filters(std::span<const GlobalId> ids, std::span<const BodyFilter> filters);
  Status remove(std::span<const GlobalId> ids);

  /// Links for those among these bodies, which are owned, that have none; all of them are touched.
  void make_links(std::span<const Local> locals);
  /// The same for all that are owned and held.
  void make_all_links();
  /// The calls for bodies that are owned here become what their links say; those for new ones stay. May throw
  /// std::bad_alloc, and has done nothing then.
  void take_own_calls(Directory& directory);

 private:
  // Whether there will be a body of this id, as far as this rank knows.
  enum class Presence { here, gone, unknown };
  Presence presence(GlobalId id, Local local) const;
  Status check_present(std::span<const GlobalId> ids) const;

  bool find_all(const Region& region, std::span<const GlobalId> ids, std::span<const Aabb> boxes);
  Status move_own(const Region& region, std::span<const Aabb> boxes);
  Status move_mixed(const Region& region, std::span<const GlobalId> ids, std::span<const Aabb> boxes);
  void mark_staged(GlobalId id);
  void take(const StagedCall& call, Local local);

  World& world_;
  Broadphase& engine_;
  std::vector<Local> locals_;       // of a call
  std::vector<Local> before_;       // of the one before
  std::vector<std::size_t> apart_;  // its boxes that other ranks may have to know
  std::vector<Local> linked_;
};

}  // namespace cellsweep::ranks
