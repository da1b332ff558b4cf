#include "broadphase/checked_broadphase.h"

#include "broadphase/input_checks.h"
#include "broadphase/pose_checks.h"
#include "base/text.h"

namespace cellsweep {

Status CheckedBroadphase::insert(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  if (Status status = check_shapes(ids, boxes, boxes_); !status.ok()) return status;
  if (Status status = make_slots(ids); !status.ok()) return status;
  apply_insert(slots_, boxes_);
  return {};
}

Status CheckedBroadphase::move(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  if (Status status = check_shapes(ids, boxes, boxes_); !status.ok()) return status;
  if (Status status = find_slots(ids); !status.ok()) return status;
  apply_move(slots_, boxes_);
  return {};
}

Status CheckedBroadphase::insert_poses(std::span<const BodyId> ids, std::span<const BodyPose> poses) {
  if (!takes_poses()) return Broadphase::insert_poses(ids, poses);
  if (Status status = check_shapes(ids, poses, poses_); !status.ok()) return status;
  if (Status status = make_slots(ids); !status.ok()) return status;
  apply_insert_poses(slots_, poses_);
  return {};
}

Status CheckedBroadphase::move_poses(std::span<const BodyId> ids, std::span<const BodyPose> poses) {
  if (!takes_poses()) return Broadphase::move_poses(ids, poses);
  if (Status status = check_shapes(ids, poses, poses_); !status.ok()) return status;
  if (Status status = find_slots(ids); !status.ok()) return status;
  apply_move_poses(slots_, poses_);
  return {};
}

Status CheckedBroadphase::remove(std::span<const BodyId> ids) {
  if (const auto twice = find_duplicate(ids))
    return duplicate_body_status(*twice, "listed twice in one call");
  if (Status status = find_slots(ids); !status.ok()) return status;
  apply_remove(slots_);
  for (const BodyId id : ids) bodies_.remove(id);
  return {};
}

template <class Shape>
Status CheckedBroadphase::check_shapes(std::span<const BodyId> ids, std::span<const Shape> shapes,
                                       std::vector<Shape>& checked) {
  if (ids.size() != shapes.size()) return length_status(ids.size(), shapes.size());
  checked.clear();
  checked.reserve(shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    checked.push_back(canonical(shapes[i]));
    if (!is_valid(checked.back())) return invalid_box_status(ids[i], shapes[i]);
  }
  if (const auto twice = find_duplicate(ids))
    return duplicate_body_status(*twice, "listed twice in one call");
  return {};
}

// Slots of new bodies, when there is room for them.
Status CheckedBroadphase::make_slots(std::span<const BodyId> ids) {
  for (const BodyId id : ids) {
    if (bodies_.find(id) != kNoSlot) return duplicate_body_status(id, "in the engine already");
  }
  if (Status status = check_room(ids.size()); !status.ok()) return status;
  bodies_.reserve_more(ids.size());
  slots_.clear();
  for (const BodyId id : ids) slots_.push_back(bodies_.insert(id));
  return {};
}

Status CheckedBroadphase::find_slots(std::span<const BodyId> ids) {
  slots_.clear();
  slots_.reserve(ids.size());
  for (const BodyId id : ids) {
    slots_.push_back(bodies_.find(id));
    if (slots_.back() == kNoSlot) return unknown_body_status(id);
  }
  return {};
}

Status CheckedBroadphase::check_room(std::size_t more) const {
  const Capacity room = capacity();
  const std::uint64_t wanted = std::uint64_t{bodies_.size()} + more;
  if (wanted <= room.bodies) return {};
  const std::string mend = room.setting.empty() ? "no setting raises this limit" : "raise " + room.setting;
  return {StatusCode::capacity,
          text("Engine ", name(), " takes ", room.bodies, " bodies, ", wanted,
               " were asked for: ", room.reason, "; ", mend, "."),
          std::nullopt,
          wanted,
          room.bodies,
          room.setting};
}

}  // namespace cellsweep
