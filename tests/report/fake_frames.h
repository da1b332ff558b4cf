/// @file
/// Frames and engines made by hand for the tests of the reports.
#pragma once

#include <utility>
#include <vector>

#include "cellsweep/broadphase.h"
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

/// An engine that says whatever it was told to say.
class FakeEngine final : public Broadphase {
 public:
  using Broadphase::insert;
  using Broadphase::move;
  using Broadphase::remove;

  explicit FakeEngine(std::vector<std::vector<Pair>> answers) : answers_(std::move(answers)) {
    statistics_.phases = {{"set-up", 1e6, true}, {"work", 0.0, false}};
  }

  std::string_view name() const override { return "fake"; }
  Capacity capacity() const override { return {1000, "", "it is fake"}; }
  Status insert(std::span<const BodyId> ids, std::span<const Aabb>) override {
    size_ += ids.size();
    return {};
  }
  Status move(std::span<const BodyId>, std::span<const Aabb>) override { return {}; }
  Status remove(std::span<const BodyId>) override { return {}; }
  Result<PairChanges> update() override {
    ++statistics_.updates;
    return PairChanges{};
  }
  std::span<const Pair> pairs() const override { return answers_[statistics_.updates - 1]; }
  std::size_t size() const override { return size_; }
  const Statistics& statistics() const override { return statistics_; }

 private:
  std::vector<std::vector<Pair>> answers_;
  std::size_t size_ = 0;
  Statistics statistics_;
};

}  // namespace cellsweep::report
