/// @file
/// Distances by the kernels of each instruction set are those of arithmetic.h, to the last bit.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cfloat>
#include <cstdint>
#include <vector>

#include "contract/random.h"
#include "queries/arithmetic.h"
#include "queries/kernels/kernel.h"

namespace cellsweep::queries {
namespace {

using contract::Random;

/// Boxes of all sizes about the origin, of which many touch; some of no extent, some as far out as floats go.
Aabb some_box(Random& random) {
  Aabb box;
  const float scale = random.one_in(8) ? FLT_MAX / 16 : 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min[axis] = static_cast<float>(random.whole(-8, 8)) * scale;
    box.max[axis] = box.min[axis] + static_cast<float>(random.whole(0, 4)) * scale;
    if (random.one_in(2)) box.max[axis] += random.unit() * scale;
    if (box.min[axis] == 0 && random.one_in(2)) box.min[axis] = -0.0F;
  }
  return box;
}

class Distances : public testing::TestWithParam<VectorIsa> {};

TEST_P(Distances, AreThoseOfArithmeticToTheLastBit) {
  Random random(7);
  std::vector<Aabb> boxes;
  for (int i = 0; i < 500; ++i) boxes.push_back(some_box(random));
  for (std::uint32_t count = 0; count <= 40; ++count) {
    const Aabb from = some_box(random);
    std::vector<std::uint32_t> slots;
    for (std::uint32_t i = 0; i < count; ++i)
      slots.push_back(static_cast<std::uint32_t>(random.below(boxes.size())));
    constexpr double kUntouched = -1;
    std::vector<double> distances(count + kDistancesAtOnce, kUntouched);
    query_kernels(GetParam()).distances(boxes.data(), slots.data(), count, from, distances.data());
    for (std::uint32_t i = 0; i < count; ++i) {
      const double expected = distance_of(from, boxes[slots[i]]);
      EXPECT_EQ(std::bit_cast<std::uint64_t>(distances[i]), std::bit_cast<std::uint64_t>(expected)) << i;
    }
    if (count % kDistancesAtOnce == 0) {
      EXPECT_EQ(distances[count], kUntouched);
    }
  }
}

TEST_P(Distances, OfANodesBoxesAreToo) {
  Random random(8);
  for (int round = 0; round < 100; ++round) {
    TreeNode node{};
    std::vector<Aabb> boxes;
    for (unsigned place = 0; place < TreeNode::kBoxes; ++place) {
      boxes.push_back(some_box(random));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        node.faces[axis][place] = boxes.back().min[axis];
        node.faces[axis + 3][place] = boxes.back().max[axis];
      }
    }
    const Aabb from = some_box(random);
    std::array<double, TreeNode::kBoxes> distances;
    query_kernels(GetParam()).trees->distances(node, from, distances.data());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(distances[i]),
                std::bit_cast<std::uint64_t>(distance_of(from, boxes[i])));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(InstructionSets, Distances,
                         testing::Values(VectorIsa::portable, VectorIsa::avx2, VectorIsa::avx512));

}  // namespace
}  // namespace cellsweep::queries
