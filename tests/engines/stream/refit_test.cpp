/// @file
/// Heaps that come to rest: what fat boxes had to hold while all moved about is not looked at for ever.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "base/memory/starved.h"
#include "cellsweep/engine/piece_finder.h"
#include "engines/stream/kernels/kernel.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

/// Cubes side by side, with little room between them.
std::vector<Aabb> heap(std::size_t edge) {
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < edge * edge * edge; ++i) {
    const std::size_t place[3] = {i % edge, i / edge % edge, i / edge / edge};
    Aabb box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = 1.1F * static_cast<float>(place[axis]);
      box.max[axis] = box.min[axis] + 1;
    }
    boxes.push_back(box);
  }
  return boxes;
}

/// Finds what the kernels find, and counts how often it is asked.
class Elsewhere final : public PieceFinder {
 public:
  explicit Elsewhere(std::uint64_t& asked) : asked_(asked) {}
  void begin_update() override {}
  void find(std::span<const CellBoxes> cells, KeyBuffer& found) override {
    ++asked_;
    const Kernels& kernels = *find_kernels(VectorIsa::best);
    for (const CellBoxes& cell : cells) kernels.all_pairs(cell, cell.count, found);
  }
  void add_counters(std::vector<Counter>&) const override {}

 private:
  std::uint64_t& asked_;
};

/// A heap that trembled much and now hardly does, on its way to a refit.
class SettlingHeap {
 public:
  explicit SettlingHeap(Broadphase engine = Broadphase()) : engine_(std::move(engine)) {
    insert_all(engine_, places_);
    EXPECT_TRUE(engine_.update().ok());
    for (int update = 0; update < 40; ++update) tremble(0.05F);
  }

  void move(float most) {
    shown_ = places_;
    shake(shown_, most, ++frame_);
    move_every(engine_, shown_, 1);
  }
  void update() { ASSERT_TRUE(engine_.update().ok()); }
  void tremble(float most) {
    move(most);
    update();
  }

  const Broadphase& engine() const { return engine_; }
  testing::AssertionResult is_right() const { return is_exact(engine_, shown_); }

 private:
  std::vector<Aabb> places_ = heap(16);  // more than are swept
  std::vector<Aabb> shown_ = places_;
  Broadphase engine_;
  std::uint64_t frame_ = 0;
};

/// So many updates at rest go before the one that makes fat boxes anew.
int updates_before_refit() {
  SettlingHeap heap;
  const std::uint64_t full = counter(heap.engine(), "full updates");
  for (int update = 0; update < 150; ++update) {
    heap.tremble(1e-4F);
    if (counter(heap.engine(), "full updates") > full) return update;
  }
  ADD_FAILURE() << "there is none";
  return 0;
}

TEST(Refit, ChangesNothingWhereMemoryFails) {
  const int before = updates_before_refit();
  bool failed = true;
  std::uint64_t n = 1;
  for (; failed && !testing::Test::HasFailure(); ++n) {
    SettlingHeap heap;
    for (int update = 0; update < before; ++update) heap.tremble(1e-4F);
    const std::vector<Pair> pairs(heap.engine().pairs().begin(), heap.engine().pairs().end());
    heap.move(1e-4F);
    failed = fails_at(n, [&] { heap.update(); });
    if (failed) {
      EXPECT_TRUE(std::ranges::equal(heap.engine().pairs(), pairs)) << "place " << n;
      heap.update();
    }
    EXPECT_TRUE(heap.is_right()) << "place " << n;
  }
  EXPECT_GT(n, 4U) << "memory is asked for in fewer places than there are";
}

// What that takes nobody knows here: to ask again may take more than to look at candidates for ever.
TEST(Refit, IsNotForPairsThatAreFoundElsewhere) {
  std::uint64_t asked = 0;
  const auto make = [&]() -> Result<std::unique_ptr<PieceFinder>> {
    return std::unique_ptr<PieceFinder>(std::make_unique<Elsewhere>(asked));
  };
  SettlingHeap heap(std::move(*make_stream_broadphase({}, "elsewhere", make, "row")));
  const std::uint64_t before = asked;
  for (int update = 0; update < 150; ++update) heap.tremble(1e-4F);
  EXPECT_TRUE(heap.is_right());
  EXPECT_EQ(asked, before);
}

TEST(Refit, LeavesFewCandidatesOnceAHeapIsAtRest) {
  SettlingHeap heap;
  const std::uint64_t moving = counter(heap.engine(), "candidates");
  EXPECT_GT(moving, 4U * 16 * 16 * 16);
  const auto rest = [&] {
    for (int update = 0; update < 150; ++update) {
      ASSERT_NO_FATAL_FAILURE(heap.tremble(1e-4F));
      if (update % 16 == 0) {
        ASSERT_TRUE(heap.is_right());
      }
    }
  };
  ASSERT_NO_FATAL_FAILURE(rest());
  EXPECT_LT(counter(heap.engine(), "candidates"), moving / 4);
  const std::uint64_t full = counter(heap.engine(), "full updates");
  ASSERT_NO_FATAL_FAILURE(rest());
  EXPECT_EQ(counter(heap.engine(), "full updates"), full) << "once is enough";
}

}  // namespace
}  // namespace cellsweep::stream
