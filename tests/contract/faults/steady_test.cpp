/// @file
/// A world that goes on as it did has the memory that it needs: its updates ask for hardly any.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "cellsweep/broadphase.h"
#include "contract/faults/failing_calls.h"
#include "contract/random.h"
#include "engines/stream/kernels/kernel.h"

namespace cellsweep::contract {
namespace {

struct Movers {
  const char* name;
  std::size_t bodies;
  std::size_t every;  // which one of so many moves
  bool is_swept;
  std::uint64_t most_calls;  // for memory, in 64 steps
};

void PrintTo(const Movers& movers, std::ostream* out) {
  *out << movers.name;
}

/// Cubes that swing about their places, each in its own way; what they do comes again after a while.
class SteadyWorld : public testing::TestWithParam<Movers> {
 protected:
  static constexpr int kPeriod = 64;

  SteadyWorld() : homes_(3 * GetParam().bodies) {
    Random random(1);
    const auto room = 1.5F * std::cbrt(static_cast<float>(GetParam().bodies));
    for (float& home : homes_) home = random.between(0, room);
    for (std::size_t i = 0; i < GetParam().bodies; i += GetParam().every)
      moved_.push_back(static_cast<BodyId>(i));
  }

  Aabb box(BodyId id, int frame) const {
    Aabb box;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const float turn = 6.2831853F * static_cast<float>(frame + static_cast<int>(17 * id)) / kPeriod;
      box.min[axis] = homes_[3 * id + axis] + (axis == 0 ? std::sin(turn) : std::cos(turn));
      box.max[axis] = box.min[axis] + 1;
    }
    return box;
  }

  void insert_all() {
    std::vector<BodyId> ids(GetParam().bodies);
    std::iota(ids.begin(), ids.end(), 0U);
    std::vector<Aabb> boxes;
    for (const BodyId id : ids) boxes.push_back(box(id, 0));
    ASSERT_TRUE(broadphase_.insert(ids, boxes).ok());
    ASSERT_TRUE(broadphase_.update().ok());
  }

  /// How often the calls of a step asked for memory.
  std::uint64_t calls_in_step(int frame) {
    boxes_.clear();
    for (const BodyId id : moved_) boxes_.push_back(box(id, frame));
    let_fail(Scarce::memory, 0);
    count_calls(true);
    const Status moved = broadphase_.move(moved_, boxes_);
    const auto changes = broadphase_.update();
    pairs_ = broadphase_.pairs().size();
    count_calls(false);
    EXPECT_TRUE(moved.ok() && changes.ok());
    return counted_calls(Scarce::memory);
  }

  Broadphase broadphase_ = std::move(*make_broadphase(StreamOptions{.threads = 1}));
  std::vector<float> homes_;
  std::vector<BodyId> moved_;
  std::vector<Aabb> boxes_;
  std::size_t pairs_ = 0;
};

// But for cells that boxes enter, which grow now and then, and the next ones of all bodies.
TEST_P(SteadyWorld, HasTheMemoryThatItNeeds) {
  const bool has_sweeps = stream::find_kernels(VectorIsa::best)->sweep != nullptr;
  if (GetParam().is_swept && !has_sweeps) GTEST_SKIP() << "cells are made anew in each update here";
  insert_all();
  for (int frame = 1; frame < 2 * kPeriod; ++frame) calls_in_step(frame);
  std::uint64_t calls = 0;
  for (int frame = 0; frame < kPeriod; ++frame) calls += calls_in_step(frame);
  EXPECT_LE(calls, GetParam().most_calls);
  EXPECT_GT(pairs_, GetParam().bodies / 10);
}

constexpr Movers kMovers[] = {{"a small world", 500, 1, true, 0},
                              {"a tenth", 3000, 10, false, 8},
                              {"few", 3000, 500, false, 8},
                              {"all, spread over updates", 3000, 1, false, 64}};
INSTANTIATE_TEST_SUITE_P(Movers, SteadyWorld, testing::ValuesIn(kMovers));

}  // namespace
}  // namespace cellsweep::contract
