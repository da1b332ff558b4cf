#include "engines/oracle/brute_force.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>

#include "geometry/canonical.h"

namespace cellsweep {
namespace {

// Boxes are compared in blocks of this many, so that the compiler can use vectors of any width up to 512
// bits.
constexpr std::size_t kLanes = 16;

// One array per face, padded to whole blocks with NaN, which overlaps nothing.
struct FaceArrays {
  explicit FaceArrays(std::span<const Aabb> boxes) {
    const std::size_t padded = (boxes.size() + kLanes - 1) / kLanes * kLanes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      min[axis].assign(padded, std::numeric_limits<float>::quiet_NaN());
      max[axis].assign(padded, std::numeric_limits<float>::quiet_NaN());
      for (std::size_t i = 0; i < boxes.size(); ++i) {
        min[axis][i] = canonical(boxes[i].min[axis]);
        max[axis][i] = canonical(boxes[i].max[axis]);
      }
    }
  }

  Aabb box(std::size_t i) const {
    return {{min[0][i], min[1][i], min[2][i]}, {max[0][i], max[1][i], max[2][i]}};
  }

  std::array<std::vector<float>, 3> min;
  std::array<std::vector<float>, 3> max;
};

using BlockHits = std::array<int, kLanes>;

// Which boxes of the block that starts at `first` overlap `box`; returns how many.
int test_block(const Aabb& box, const FaceArrays& faces, std::size_t first, BlockHits& hits) {
  hits.fill(1);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float* low = faces.min[axis].data() + first;
    const float* high = faces.max[axis].data() + first;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      hits[lane] &=
          static_cast<int>(box.min[axis] <= high[lane]) & static_cast<int>(low[lane] <= box.max[axis]);
    }
  }
  return std::accumulate(hits.begin(), hits.end(), 0);
}

}  // namespace

std::vector<Pair> brute_force_pairs(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  const FaceArrays faces(boxes);
  std::vector<Pair> pairs;
  BlockHits hits{};
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Aabb box = faces.box(i);
    for (std::size_t first = i / kLanes * kLanes; first < boxes.size(); first += kLanes) {
      if (test_block(box, faces, first, hits) == 0) continue;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const std::size_t other = first + lane;
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
