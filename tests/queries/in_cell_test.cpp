#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <memory>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/engine/cell_boxes.h"
#include "contract/random.h"
#include "geometry/box_lanes.h"
#include "queries/kernels/kernel.h"
#include "queries/rows.h"

namespace cellsweep::queries {
namespace {

using contract::Random;
using stream::TaggedBox;

/// Numbers that meet each other often, and the ends of what a box may have.
float number_that_meets(Random& random) {
  constexpr float kNumbers[] = {-FLT_MAX, -2, -1, -FLT_MIN, 0, FLT_MIN, 1, 1 + FLT_EPSILON, 2, FLT_MAX};
  return kNumbers[random.bits() % std::size(kNumbers)];
}

Aabb box_that_meets(Random& random) {
  Aabb box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float one = number_that_meets(random);
    const float other = random.bits() % 4 == 0 ? one : number_that_meets(random);
    box.min[axis] = std::min(one, other);
    box.max[axis] = std::max(one, other);
  }
  return box;
}

/// Room for a whole vector behind the last one, with boxes that overlap everything.
std::vector<TaggedBox> some_cell(Random& random, std::uint32_t count) {
  const Aabb all{{-FLT_MAX, -FLT_MAX, -FLT_MAX}, {FLT_MAX, FLT_MAX, FLT_MAX}};
  std::vector<TaggedBox> boxes(count + kMostLanes, TaggedBox{all, stream::kWholeFlags << kSlotBits, ~0U});
  for (std::uint32_t i = 0; i < count; ++i) {
    boxes[i].box = random.bits() % 8 == 0 ? kNobody : box_that_meets(random);
    boxes[i].tag = static_cast<std::uint32_t>(random.bits() % 8) << kSlotBits | (1000 + i);
  }
  return boxes;
}

class InCell : public testing::TestWithParam<VectorIsa> {};

TEST_P(InCell, FindsTheBoxesThatOverlapAndThatTheCellOwns) {
  const QueryKernels& kernels = query_kernels(GetParam());
  const auto slots = std::make_unique<Places>();
  Random random(6);
  for (std::uint32_t round = 0; round < 4000; ++round) {
    const auto count = static_cast<std::uint32_t>(round < 260 ? round % 257 : random.bits() % 80);
    const std::vector<TaggedBox> cell = some_cell(random, count);
    const Aabb box = box_that_meets(random);
    const auto flags = static_cast<std::uint32_t>(random.bits() % 8);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < count; ++i) {
      const bool is_owned = (cell[i].tag >> kSlotBits | flags) == stream::kWholeFlags;
      if (is_owned && overlap(BoxLanes(cell[i].box), BoxLanes(box))) expected.push_back(1000 + i);
    }
    const std::uint32_t found = kernels.overlap_in_cell(cell.data(), count, box, flags, slots->data());
    ASSERT_EQ(std::vector<std::uint32_t>(slots->data(), slots->data() + found), expected) << count;
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, InCell,
                         testing::Values(VectorIsa::portable, VectorIsa::avx2, VectorIsa::avx512));

}  // namespace
}  // namespace cellsweep::queries
