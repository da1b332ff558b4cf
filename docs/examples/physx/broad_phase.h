/// @file
/// A broadphase with the face of PhysX's PxBroadPhase: the caller keeps one array of bounds and one of
/// groups, names by index which of them are new, changed and gone, and fetches the pairs found and lost.
#pragma once

#include <cellsweep/broadphase.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace physx_front {

using Index = std::uint32_t;  // PxBpIndex

/// PxBpFilterGroup, as PxGetBroadPhaseStaticFilterGroup() and its kin hand it out: objects of one group never
/// meet, and those of kStatic are the static ones.
using Group = std::uint32_t;
inline constexpr Group kStatic = 0;

/// PxBroadPhaseUpdateData. Indices point into `bounds` and `groups`, which hold all objects; an index may
/// stand in one of the three lists only. `distances`, by which bounds are grown (contact offsets), may be
/// empty.
struct UpdateData {
  std::span<const Index> created;
  std::span<const Index> updated;
  std::span<const Index> removed;
  std::span<const cellsweep::Aabb> bounds;
  std::span<const Group> groups;
  std::span<const float> distances;
};

/// PxBroadPhaseResults: the pairs that began and ended, ascending; valid until the next update().
struct Results {
  std::span<const cellsweep::Pair> created_pairs;
  std::span<const cellsweep::Pair> deleted_pairs;
};

class BroadPhase {
 public:
  /// PxBroadPhase::update() and fetchResults() in one: when it returns, the pairs are there. False when the
  /// data contradict themselves; error() says how.
  bool update(const UpdateData& data);
  const Results& results() const { return results_; }
  const std::string& error() const { return error_; }

 private:
  bool noted(const cellsweep::Status& status);
  void gather(std::span<const Index> indices, const UpdateData& data);
  void note_groups(const UpdateData& data);
  std::span<const cellsweep::Pair> of_two_groups(std::span<const cellsweep::Pair> pairs,
                                                 std::vector<cellsweep::Pair>& kept) const;

  cellsweep::Broadphase broadphase_;
  Results results_;
  std::string error_;
  std::vector<Group> groups_;                   // by index, also of objects that are gone
  std::vector<cellsweep::Aabb> boxes_;          // of the list that is being handed on
  std::vector<cellsweep::BodyFilter> filters_;  // of the objects that are created
  std::vector<cellsweep::Pair> created_;
  std::vector<cellsweep::Pair> deleted_;
};

}  // namespace physx_front
