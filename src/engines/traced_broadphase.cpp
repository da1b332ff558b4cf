#include "engines/traced_broadphase.h"

#include <utility>

namespace cellsweep {

TracedBroadphase::TracedBroadphase(std::unique_ptr<Broadphase> engine, std::shared_ptr<Timeline> timeline,
                                   std::string row_name)
    : timeline_(std::move(timeline)),
      engine_(std::move(engine)),
      row_{timeline_.get(), timeline_->add_row(std::move(row_name))} {}

Status TracedBroadphase::insert(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  const TimelineScope scope(row_);
  const TimelineSpan span("insert");
  return engine_->insert(ids, boxes);
}

Status TracedBroadphase::move(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  const TimelineScope scope(row_);
  const TimelineSpan span("move");
  return engine_->move(ids, boxes);
}

Status TracedBroadphase::remove(std::span<const BodyId> ids) {
  const TimelineScope scope(row_);
  const TimelineSpan span("remove");
  return engine_->remove(ids);
}

Status TracedBroadphase::insert_poses(std::span<const BodyId> ids, std::span<const BodyPose> poses) {
  const TimelineScope scope(row_);
  const TimelineSpan span("insert");
  return engine_->insert_poses(ids, poses);
}

Status TracedBroadphase::move_poses(std::span<const BodyId> ids, std::span<const BodyPose> poses) {
  const TimelineScope scope(row_);
  const TimelineSpan span("move");
  return engine_->move_poses(ids, poses);
}

Status TracedBroadphase::boxes(std::span<const BodyId> ids, std::span<Aabb> boxes) const {
  return engine_->boxes(ids, boxes);
}

Result<PairChanges> TracedBroadphase::update() {
  const TimelineScope scope(row_);
  const TimelineSpan span("update");
  return engine_->update();
}

}  // namespace cellsweep
