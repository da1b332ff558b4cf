/// @file
/// Frames and an engine made by hand for the tests of the reports.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cellsweep/engine/engine.h"
#include "cellsweep/world/frame_source.h"

namespace cellsweep::report {

/// Frames given as lists of boxes; a body has moved when its box differs.
class FakeFrames final : public FrameSource {
 public:
  explicit FakeFrames(std::vector<std::vector<Aabb>> frames) : frames_(std::move(frames)) {}

  std::string name() const override { return "fake"; }
  std::span<const Aabb> boxes() const override { return frames_[frame_]; }
  std::span<const BodyId> moved() const override { return moved_; }
  bool advance() override {
    if (frame_ + 1 == frames_.size()) return false;
    ++frame_;
    moved_.clear();
    for (BodyId id = 0; id < frames_[frame_].size(); ++id) {
      if (frames_[frame_][id] != frames_[frame_ - 1][id]) moved_.push_back(id);
    }
    return true;
  }

 private:
  std::vector<std::vector<Aabb>> frames_;
  std::vector<BodyId> moved_;
  std::size_t frame_ = 0;
};

/// Two unit cubes that overlap at frame 0, part at frame 1 and meet again at frame 2.
inline FakeFrames meeting_cubes() {
  const Aabb at_zero{{0, 0, 0}, {1, 1, 1}};
  const Aabb beside{{0.5F, 0, 0}, {1.5F, 1, 1}};
  const Aabb away{{5, 0, 0}, {6, 1, 1}};
  return FakeFrames({{at_zero, beside}, {at_zero, away}, {at_zero, beside}});
}

/// Two unit cubes that overlap at frame 0; at frame 1 the second is gone.
class LeavingCube final : public FrameSource {
 public:
  std::string name() const override { return "leaving"; }
  bool bodies_come_and_go() const override { return true; }
  std::span<const Aabb> boxes() const override { return kBoxes; }
  std::span<const BodyId> bodies() const override { return std::span(kIds).first(has_left_ ? 1 : 2); }
  std::span<const BodyId> moved() const override { return {}; }
  std::span<const BodyId> removed() const override { return std::span(kIds).last(has_left_ ? 1 : 0); }
  bool advance() override { return !std::exchange(has_left_, true); }

 private:
  static constexpr std::array<Aabb, 2> kBoxes = {Aabb{{0, 0, 0}, {1, 1, 1}},
                                                 Aabb{{0.5F, 0, 0}, {1.5F, 1, 1}}};
  static constexpr std::array<BodyId, 2> kIds = {0, 1};

  bool has_left_ = false;
};

/// An engine that says whatever it was told to say, frame by frame, and claims to have taken long.
class FakeEngine final : public Engine {
 public:
  using Answers = std::vector<std::vector<SlotPair>>;

  static constexpr double kSetupMs = 1e6;
  static constexpr double kWorkMs = 2;
  static constexpr double kSpesMs = 3;

  explicit FakeEngine(Answers answers) : answers_(std::move(answers)) {}

  Capacity capacity() const override { return {1000, "", "it is fake"}; }

  Result<FoundPairs> update(const BodyChanges&, Statistics& statistics) override {
    statistics.phases = {{"set-up", kSetupMs, PhaseKind::setup},
                         {"work", kWorkMs, PhaseKind::work},
                         {"spus", kSpesMs, PhaseKind::spes},
                         {"fill", kSetupMs, PhaseKind::setup}};
    FoundPairs found;
    found.began = answers_[frame_++];
    found.is_whole_set = true;
    return found;
  }

 private:
  Answers answers_;
  std::size_t frame_ = 0;
};

/// A broadphase with a FakeEngine.
inline Broadphase make_fake(const FakeEngine::Answers& answers) {
  return std::move(*EngineAccess::make("fake", [answers]() -> Result<std::unique_ptr<Engine>> {
    return std::unique_ptr<Engine>(std::make_unique<FakeEngine>(answers));
  }));
}

}  // namespace cellsweep::report
