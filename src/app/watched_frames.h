/// @file
/// Frames with an eye on them, for work that only asks for one after the other.
#pragma once

#include <utility>

#include "cellsweep/world/frame_source.h"
#include "report/interrupt.h"
#include "report/progress.h"

namespace cellsweep::app {

/// The frames of another source, which lives longer: shows how far they have come, and ends with Ctrl-C.
class WatchedFrames final : public FrameSource {
 public:
  WatchedFrames(FrameSource& frames, std::string what, std::size_t updates)
      : frames_(frames), progress_(std::move(what), updates) {}

  std::string name() const override { return frames_.name(); }
  bool bodies_come_and_go() const override { return frames_.bodies_come_and_go(); }
  std::span<const Aabb> boxes() const override { return frames_.boxes(); }
  std::span<const BodyId> bodies() const override { return frames_.bodies(); }
  std::span<const BodyPose> poses() const override { return frames_.poses(); }
  std::span<const BodyFilter> filters() const override { return frames_.filters(); }
  std::span<const BodyId> moved() const override { return frames_.moved(); }
  std::span<const BodyId> inserted() const override { return frames_.inserted(); }
  std::span<const BodyId> removed() const override { return frames_.removed(); }
  Status status() const override { return frames_.status(); }
  bool advance() override {
    if (report::is_interrupted() || !frames_.advance()) return false;
    progress_.show(++done_);
    return true;
  }

 private:
  FrameSource& frames_;
  report::Progress progress_;
  std::size_t done_ = 0;
};

}  // namespace cellsweep::app
