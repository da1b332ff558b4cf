/// @file
/// The kernels of every instruction set against the plain overlap test.
#include "engines/stream/kernels/kernel.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "contract/random.h"
#include "engines/stream/cells/grid.h"
#include "engines/stream/cells/keys.h"

namespace cellsweep::stream {
namespace {

using contract::Random;

/// A cell with memory of its own.
class TestCell {
 public:
  explicit TestCell(std::uint32_t count)
      : memory_((count + kBoxesTogether - 1) / kBoxesTogether * kBoxesTogether) {
    boxes_ = {memory_.data(), count, static_cast<std::uint32_t>(memory_.size())};
  }
  TestCell(const TestCell& other) : memory_(other.memory_), boxes_(other.boxes_) {
    boxes_.boxes = memory_.data();
  }

  void set(std::uint32_t place, const Aabb& box, std::uint32_t tag) { memory_[place] = {box, tag, 0}; }
  const Aabb& box(std::uint32_t place) const { return memory_[place].box; }
  std::uint32_t tag(std::uint32_t place) const { return memory_[place].tag; }
  const CellBoxes& boxes() const { return boxes_; }

 private:
  std::vector<TaggedBox> memory_;
  CellBoxes boxes_;
};

Aabb random_box(Random& random) {
  Aabb box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min[axis] = static_cast<float>(random.whole(0, 6));
    box.max[axis] = box.min[axis] + static_cast<float>(random.whole(0, 3));
  }
  return box;
}

std::uint32_t random_tag(Random& random, std::uint32_t slot) {
  return slot | static_cast<std::uint32_t>(random.below(8) | random.below(8)) << kSlotBits;
}

TestCell random_cell(Random& random, std::uint32_t count) {
  TestCell cell(count);
  for (std::uint32_t i = 0; i < count; ++i) cell.set(i, random_box(random), random_tag(random, i));
  return cell;
}

bool is_owned(const TestCell& cell, std::uint32_t i, std::uint32_t j) {
  return overlap(cell.box(i), cell.box(j)) && ((cell.tag(i) | cell.tag(j)) >> kSlotBits) == kWholeFlags;
}

std::vector<std::uint64_t> sorted(const Keys& keys) {
  std::vector<std::uint64_t> all(keys.view().begin(), keys.view().end());
  std::sort(all.begin(), all.end());
  return all;
}

class KernelOf : public testing::TestWithParam<VectorIsa> {
 protected:
  void SetUp() override {
    kernels_ = find_kernels(GetParam());
    if (kernels_ == nullptr) GTEST_SKIP() << "this machine or build does not have it";
  }
  const Kernels* kernels_ = nullptr;
};

TEST_P(KernelOf, FindsEveryPairThatTheCellOwnsOnce) {
  Random random(1);
  for (std::uint32_t count = 0; count < 150; ++count) {
    const TestCell cell = random_cell(random, count);
    std::vector<std::uint64_t> expected;
    for (std::uint32_t i = 0; i < count; ++i) {
      for (std::uint32_t j = i + 1; j < count; ++j) {
        if (is_owned(cell, i, j)) expected.push_back(pair_key(SlotPair{i, j}));
      }
    }
    Keys found;
    kernels_->all_pairs(cell.boxes(), cell.boxes().count, found.buffer());
    ASSERT_EQ(sorted(found), expected) << count << " boxes";
  }
}

TEST_P(KernelOf, ComparesTheRowsThatItIsAskedFor) {
  Random random(2);
  for (std::uint32_t count = 0; count < 150; count += 7) {
    const TestCell cell = random_cell(random, count);
    for (const std::uint32_t rows : {0U, count / 3, count / 2 + 1, count}) {
      if (rows > count) continue;
      std::vector<std::uint64_t> expected;
      for (std::uint32_t i = 0; i < rows; ++i) {
        for (std::uint32_t j = i + 1; j < count; ++j) {
          if (is_owned(cell, i, j)) expected.push_back(pair_key(SlotPair{i, j}));
        }
      }
      Keys found;
      kernels_->all_pairs(cell.boxes(), rows, found.buffer());
      ASSERT_EQ(sorted(found), expected) << rows << " of " << count << " boxes";
    }
  }
}

// Wherever in the cell they stand.
TEST_P(KernelOf, NamesBodiesByTheirSlotsTheLowerFirst) {
  for (const auto& [one, other] : {std::pair{kSlotMask, 7U}, {7U, kSlotMask}, {0U, 1U}}) {
    TestCell cell(2);
    cell.set(0, Aabb{}, one | kWholeFlags << kSlotBits);
    cell.set(1, Aabb{}, other | kWholeFlags << kSlotBits);
    Keys found;
    kernels_->all_pairs(cell.boxes(), cell.boxes().count, found.buffer());
    EXPECT_EQ(sorted(found), std::vector<std::uint64_t>{pair_key(make_slot_pair(one, other))});
  }
}

TEST_P(KernelOf, StopsWhereThereAreMorePairsThanThereMayBe) {
  TestCell cell(400);
  for (std::uint32_t i = 0; i < 400; ++i) cell.set(i, Aabb{}, i | kWholeFlags << kSlotBits);
  Keys found;
  found.buffer().most = 1000;
  EXPECT_THROW(kernels_->all_pairs(cell.boxes(), cell.boxes().count, found.buffer()), TooManyPairs);
}

// Some of them outside of the grid, some without a body, next to each other and with tags in between.
TEST_P(KernelOf, FindsTheCellsOfEightBoxesThatTheGridFinds) {
  Random random(3);
  const Grid grid({1, -2, 0.5}, {0.9, 1.7, 0.25}, {7, 5, 9});
  for (int round = 0; round < 500; ++round) {
    Aabb boxes[8];
    TaggedBox tagged[8];
    for (unsigned i = 0; i < 8; ++i) {
      boxes[i] = random.one_in(9) ? kNobody : random_box(random);
      tagged[i] = {boxes[i], i, 0};
    }
    EightBlocks blocks;
    EightBlocks of_tagged;
    kernels_->eight_blocks(boxes, sizeof(Aabb), grid.numbers(), blocks);
    kernels_->eight_blocks(&tagged[0].box, sizeof(TaggedBox), grid.numbers(), of_tagged);
    for (unsigned i = 0; i < 8; ++i) {
      ASSERT_EQ(blocks.more[i], of_tagged.more[i]);
      if (std::isnan(boxes[i].min[0])) {
        ASSERT_EQ(blocks.more[i], EightBlocks::kNobody);
        continue;
      }
      std::vector<std::uint32_t> cells;
      grid.for_each_cell(grid.block_of(boxes[i]), [&](std::uint32_t cell, std::uint32_t flags) {
        cells.push_back(cell | flags << kSlotBits);
      });
      ASSERT_EQ(blocks.more[i] <= 1, cells.size() <= 2);
      ASSERT_EQ(blocks.first[i], cells.front());
      ASSERT_EQ(of_tagged.first[i], cells.front());
      if (cells.size() > 2) continue;
      ASSERT_EQ(blocks.more[i], cells.size() - 1);
      ASSERT_EQ(blocks.second[i], cells.back());
      ASSERT_EQ(of_tagged.second[i], cells.back());
    }
  }
}

TEST_P(KernelOf, FindsTheNumbersOfEightBoxesThatTheGridFinds) {
  if (kernels_->eight_rows == nullptr) {
    EXPECT_EQ(GetParam(), VectorIsa::portable) << "all others sweep";
    return;
  }
  Random random(4);
  const Grid grid({1, -2, 0.5}, {0.9, 1.7, 0.25}, {7, 256, 9});
  for (unsigned round = 0; round < 600; ++round) {
    Aabb boxes[8];
    for (Aabb& box : boxes) box = random.one_in(9) ? kNobody : random_box(random);
    const unsigned axis = round % 3, y = (axis + 1) % 3, z = (axis + 2) % 3;
    EightRows rows;
    kernels_->eight_rows(boxes, grid.numbers(), axis, rows);
    for (unsigned i = 0; i < 8; ++i) {
      const bool is_somebody = !std::isnan(boxes[i].min[0]);
      ASSERT_EQ(rows.there >> i & 1, is_somebody ? 1U : 0U);
      if (!is_somebody) continue;
      const auto [low, high] = grid.range_of(boxes[i]);
      ASSERT_EQ(rows.on_axis[i], low[axis] | high[axis] << 16);
      ASSERT_EQ(rows.on_others[i], low[y] | high[y] << 8 | low[z] << 16 | high[z] << 24);
    }
  }
}

TEST_P(KernelOf, AnswersToItsName) {
  EXPECT_EQ(kernels_->isa, GetParam());
}

INSTANTIATE_TEST_SUITE_P(
    All, KernelOf, testing::Values(VectorIsa::portable, VectorIsa::sse41, VectorIsa::avx2, VectorIsa::avx512),
    [](const auto& test) { return "Isa" + std::to_string(static_cast<int>(test.param)); });

TEST(Kernels, TheBestAreThereAndTheWidestOfThoseThatThereAre) {
  const Kernels* best = find_kernels(VectorIsa::best);
  ASSERT_NE(best, nullptr);
  for (const VectorIsa isa : {VectorIsa::portable, VectorIsa::sse41, VectorIsa::avx2, VectorIsa::avx512}) {
    const Kernels* other = find_kernels(isa);
    EXPECT_TRUE(other == nullptr || best->lanes >= other->lanes);
  }
}

#ifdef __x86_64__
/// What the operating system says that programs may use; empty where it does not say.
std::set<std::string> processor_flags() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("flags")) continue;
    std::istringstream words(line);
    return {std::istream_iterator<std::string>(words), {}};
  }
  return {};
}

TEST(Kernels, TheBestAreTheWidestThatTheOperatingSystemLetsProgramsUse) {
  const std::set<std::string> flags = processor_flags();
  if (flags.empty()) GTEST_SKIP() << "no /proc/cpuinfo";
  VectorIsa widest = VectorIsa::portable;
  if (flags.contains("sse4_1")) widest = VectorIsa::sse41;
  if (flags.contains("avx2")) widest = VectorIsa::avx2;
  if (flags.contains("avx512f")) widest = VectorIsa::avx512;
  EXPECT_EQ(find_kernels(VectorIsa::best)->isa, widest);
}
#endif

}  // namespace
}  // namespace cellsweep::stream
