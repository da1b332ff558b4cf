/// @file
/// Any engine, with every call that works noted on a timeline.
#pragma once

#include <memory>
#include <string>

#include "cellsweep/broadphase.h"
#include "cellsweep/engine/timeline.h"

namespace cellsweep {

/// Passes every call on. Spans of the row `row_name`: the calls, the phases of an update in it, waits in
/// these.
class TracedBroadphase final : public Broadphase {
 public:
  TracedBroadphase(std::unique_ptr<Broadphase> engine, std::shared_ptr<Timeline> timeline,
                   std::string row_name);

  using Broadphase::insert;
  using Broadphase::move;
  using Broadphase::remove;
  std::string_view name() const override { return engine_->name(); }
  Capacity capacity() const override { return engine_->capacity(); }
  Status insert(std::span<const BodyId> ids, std::span<const Aabb> boxes) override;
  Status move(std::span<const BodyId> ids, std::span<const Aabb> boxes) override;
  Status remove(std::span<const BodyId> ids) override;
  Status insert_poses(std::span<const BodyId> ids, std::span<const BodyPose> poses) override;
  Status move_poses(std::span<const BodyId> ids, std::span<const BodyPose> poses) override;
  Status boxes(std::span<const BodyId> ids, std::span<Aabb> boxes) const override;
  Result<PairChanges> update() override;
  std::span<const Pair> pairs() const override { return engine_->pairs(); }
  std::size_t size() const override { return engine_->size(); }
  const Statistics& statistics() const override { return engine_->statistics(); }

 private:
  // The engine's SPEs end before the timeline may be written.
  std::shared_ptr<Timeline> timeline_;
  std::unique_ptr<Broadphase> engine_;
  TimelineRow row_;
};

}  // namespace cellsweep
