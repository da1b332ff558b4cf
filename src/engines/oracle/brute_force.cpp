#include "engines/oracle/brute_force.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>

#include "geometry/box_lanes.h"
#include "geometry/canonical.h"

namespace cellsweep {
namespace {

// So many boxes are compared at a time, as vectors of the language: a sanitized compiler makes none of loops.
constexpr std::size_t kLanes = 4;

struct Block {
  std::array<Float4, 3> min;
  std::array<Float4, 3> max;
};

// The last block is filled up with NaN, which overlaps nothing.
std::vector<Block> blocks_of(std::span<const Aabb> boxes) {
  const Float4 padding = Float4{} + std::numeric_limits<float>::quiet_NaN();
  std::vector<Block> blocks((boxes.size() + kLanes - 1) / kLanes,
                            {{padding, padding, padding}, {padding, padding, padding}});
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    Block& block = blocks[i / kLanes];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      block.min[axis][i % kLanes] = canonical(boxes[i].min[axis]);
      block.max[axis][i % kLanes] = canonical(boxes[i].max[axis]);
    }
  }
  return blocks;
}

// Which boxes of `block` overlap the box in that lane of `its`: not 0 in their lanes.
Int4 test_block(const Block& its, std::size_t lane, const Block& block) {
  const auto overlap = [&](std::size_t axis) {
    return (its.min[axis][lane] <= block.max[axis]) & (block.min[axis] <= its.max[axis][lane]);
  };
  return overlap(0) & overlap(1) & overlap(2);
}

bool any(Int4 lanes) {
  return (lanes[0] | lanes[1] | lanes[2] | lanes[3]) != 0;
}

}  // namespace

std::vector<Pair> brute_force_pairs(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  const std::vector<Block> blocks = blocks_of(boxes);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Block its = blocks[i / kLanes];
    for (std::size_t block = i / kLanes; block < blocks.size(); ++block) {
      const Int4 hits = test_block(its, i % kLanes, blocks[block]);
      if (!any(hits)) continue;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const std::size_t other = block * kLanes + lane;
        if (hits[lane] != 0 && other > i) pairs.push_back(make_pair_of(ids[i], ids[other]));
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<Pair> brute_force_pairs(std::span<const Aabb> boxes) {
  std::vector<BodyId> ids(boxes.size());
  std::iota(ids.begin(), ids.end(), BodyId{0});
  return brute_force_pairs(ids, boxes);
}

}  // namespace cellsweep
