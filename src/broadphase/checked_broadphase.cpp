#include "broadphase/checked_broadphase.h"

#include "broadphase/input_checks.h"
#include "broadphase/text.h"

namespace cellsweep {

Status CheckedBroadphase::insert(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  if (Status status = check_boxes(ids, boxes); !status.ok()) return status;
  for (const BodyId id : ids) {
    if (bodies_.find(id) != kNoSlot) return duplicate_body_status(id, "in the engine already");
  }
  if (Status status = check_room(ids.size()); !status.ok()) return status;
  bodies_.reserve_more(ids.size());
  slots_.clear();
  for (const BodyId id : ids) slots_.push_back(bodies_.insert(id));
  apply_insert(slots_, boxes_);
  return {};
}

Status CheckedBroadphase::move(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  if (Status status = check_boxes(ids, boxes); !status.ok()) return status;
  if (Status status = find_slots(ids); !status.ok()) return status;
  apply_move(slots_, boxes_);
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

Status CheckedBroadphase::check_boxes(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  if (ids.size() != boxes.size()) return length_status(ids.size(), boxes.size());
  boxes_.clear();
  boxes_.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    boxes_.push_back(canonical(boxes[i]));
    if (!is_valid(boxes_.back())) return invalid_box_status(ids[i], boxes[i]);
  }
  if (const auto twice = find_duplicate(ids))
    return duplicate_body_status(*twice, "listed twice in one call");
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
