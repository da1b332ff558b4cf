#include "engines/stream/cells/box_sample.h"

#include <algorithm>
#include <cfloat>
#include <span>

#include "base/memory/memory.h"
#include "base/tuning.h"
#include "cellsweep/pair.h"
#include "engines/stream/cells/lane_sort.h"
#include "geometry/box_lanes.h"

namespace cellsweep::stream {
namespace {

using tuning::kLargeEdges;
using tuning::kSample;

/// Some of the boxes, evenly spread over the list; slots without a body are left out.
struct Drawn {
  std::array<Aabb, kSample> boxes;
  std::size_t count = 0;

  std::span<const Aabb> view() const { return {boxes.data(), count}; }
};

void draw(const Boxes& boxes, Drawn& drawn) {
  const std::size_t wanted = std::min(boxes.count(), std::min(kSample, 24 + boxes.count() / 64));
  for (std::size_t i = 0; i < wanted; ++i) {
    const Aabb& box = boxes[i * boxes.count() / wanted];
    drawn.boxes[drawn.count] = box;
    drawn.count += box.min[0] <= box.max[0] ? 1 : 0;
  }
}

/// Twice the range of the middle half, not beyond the range of all. What lies outside falls into the cells at
/// the border, which are cut again when they are crowded.
AxisRange range_of(double low, double quarter, double last_quarter, double high) {
  const double middle_half = last_quarter - quarter;
  if (!(middle_half > 0)) return {low, high - low, low, high};
  const double origin = std::max(low, quarter - middle_half / 2);
  return {origin, std::min(high, quarter + 1.5 * middle_half) - origin, low, high};
}

std::array<AxisRange, 3> measure_axes(std::span<const Aabb> boxes) {
  std::array<Float4, kSample> minima;  // NOLINT(*-member-init): as far as it is read
  const std::size_t count = boxes.size();
  for (std::size_t i = 0; i < count; ++i) minima[i] = BoxLanes(boxes[i]).min;
  sort_lanes({minima.data(), count});
  std::array<AxisRange, 3> ranges;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    ranges[axis] = range_of(minima[0][axis], minima[count / 4][axis], minima[count - 1 - count / 4][axis],
                            minima[count - 1][axis]);
  }
  return ranges;
}

/// The same of an axis of all boxes, of which there are some. `minima` is working memory.
[[gnu::cold]] AxisRange measure_axis(const Boxes& boxes, std::size_t axis, Vector<float>& minima) {
  minima.clear();
  for (std::size_t i = 0; i < boxes.count(); ++i) {
    const Aabb& box = boxes[i];
    if (box.min[0] <= box.max[0]) minima.push_back(box.min[axis]);
  }
  const auto [low, high] = std::minmax_element(minima.begin(), minima.end());
  const std::array<float, 2> ends = {*low, *high};
  const auto value_at = [&](std::size_t place) {
    const auto nth = minima.begin() + static_cast<std::ptrdiff_t>(place);
    std::nth_element(minima.begin(), nth, minima.end());
    return *nth;
  };
  const std::size_t quarter = minima.size() / 4;
  const double first = value_at(quarter);
  return range_of(ends[0], first, value_at(minima.size() - 1 - quarter), ends[1]);
}

/// What of a box lies in the ranges of the axes: the rest falls into cells at the border, whatever its size.
class Ranges {
 public:
  explicit Ranges(const std::array<AxisRange, 3>& axes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_[axis] = static_cast<float>(axes[axis].origin);
      high_[axis] = static_cast<float>(std::min(axes[axis].origin + axes[axis].length, double{FLT_MAX}));
    }
  }

  /// In lanes 0 to 2; of nobody 0.
  Float4 edges(const Aabb& box) const {
    const BoxLanes lanes(box);
    return clamped(lanes.max) - clamped(lanes.min);
  }

 private:
  Float4 clamped(Float4 values) const {
    values = values > low_ ? values : low_;
    return values < high_ ? values : high_;
  }

  Float4 low_{};
  Float4 high_{};
};

/// The edges beyond which a box is large. A few boxes tell the middle edge well enough, if they do not stand
/// at equal distances, as large ones do sometimes.
Float4 large_edges(std::span<const Aabb> boxes, const Ranges& ranges) {
  constexpr std::size_t kFarApart = 37;
  std::array<Float4, tuning::kEdgeSample> edges;  // NOLINT(*-member-init): as far as it is read
  const std::size_t count = std::min(boxes.size(), tuning::kEdgeSample);
  for (std::size_t i = 0; i < count; ++i) edges[i] = ranges.edges(boxes[i * kFarApart % boxes.size()]);
  sort_lanes({edges.data(), count});
  const Float4 limits = edges[count / 2] * kLargeEdges;
  const Float4 most = Float4{} + FLT_MAX;
  return limits < most ? limits : most;
}

/// Sums of the extents of boxes that are large, or of those that are not, and how many there are.
struct Sums {
  Extents extents;
  double count = 0;

  void add(Float4 edges) {
    extents.add({edges[0], edges[1], edges[2]});
    ++count;
  }
  void add(const Sums& other) {
    extents.add(other.extents, 1);
    count += other.count;
  }
};

/// Where an edge is longer than its limit. Most are not even with what lies outside of the ranges, which is
/// asked sooner.
Int4 may_be_large(const Aabb& box, Float4 limits) {
  const BoxLanes lanes(box);
  return (lanes.max - lanes.min) > limits;
}

// Four boxes are asked at a time. Which of them are large nobody can foretell: a list is made without a
// branch. Not inlined: that would be a kilobyte for each caller.
[[gnu::noinline]] Sums sum_large(const Boxes& boxes, const Ranges& ranges, Float4 limits) {
  Sums sums;
  const auto add = [&](std::size_t i) {
    const Float4 edges = ranges.edges(boxes[i]);
    if (on_any_axis(edges > limits)) sums.add(edges);
  };
  std::size_t i = 0;
  for (; i + 4 <= boxes.count(); i += 4) {
    std::array<Int4, 4> large;
    for (std::size_t k = 0; k < 4; ++k) large[k] = may_be_large(boxes[i + k], limits);
    if (!on_any_axis((large[0] | large[1]) | (large[2] | large[3]))) continue;
    std::array<std::size_t, 4> picked;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      picked[count] = i + k;
      count += on_any_axis(large[k]) ? 1 : 0;
    }
    for (std::size_t k = 0; k < count; ++k) add(picked[k]);
  }
  for (; i < boxes.count(); ++i) add(i);
  return sums;
}

Sums sum_all(std::span<const Aabb> boxes, const Ranges& ranges) {
  Sums sums;
  for (const Aabb& box : boxes) sums.add(ranges.edges(box));
  return sums;
}

/// Sums of large boxes, of so many.
struct LargeBoxes {
  Sums sums;
  std::size_t of = 0;
};

// Runs of boxes from places that nobody foretells: large ones often stand in line, or at equal distances.
LargeBoxes sum_large_of_some(const Boxes& boxes, const Ranges& ranges, Float4 limits) {
  constexpr std::size_t kRuns = tuning::kLargeSample / tuning::kRunOfSample;
  LargeBoxes large;
  for (std::size_t run = 0; run < kRuns; ++run) {
    const std::size_t low = run * boxes.count() / kRuns;
    const std::size_t high = (run + 1) * boxes.count() / kRuns - tuning::kRunOfSample;
    const std::size_t first = low + mix64(run) % (high - low);
    large.sums.add(sum_large(boxes.part(first, tuning::kRunOfSample), ranges, limits));
    large.of += tuning::kRunOfSample;
  }
  return large;
}

// Some tell as much as all when there are many large ones among them.
LargeBoxes find_large(const Boxes& boxes, const Ranges& ranges, Float4 limits) {
  if (boxes.count() >= 4 * tuning::kLargeSample) {
    const LargeBoxes large = sum_large_of_some(boxes, ranges, limits);
    if (large.sums.count >= tuning::kManyLarge) return large;
  }
  return {sum_large(boxes, ranges, limits), boxes.count()};
}

Sums sum_usual(std::span<const Aabb> boxes, const Ranges& ranges, Float4 limits) {
  Sums sums;
  for (const Aabb& box : boxes) {
    const Float4 edges = ranges.edges(box);
    if (!on_any_axis(edges > limits)) sums.add(edges);
  }
  return sums;
}

}  // namespace

void Extents::add(const std::array<double, 3>& edges) {
  const auto [i, j, k] = edges;
  add(Extents{i, j, k, i * j, j * k, k * i, i * j * k}, 1);
}

void Extents::add(const Extents& other, double weight) {
  x += weight * other.x, y += weight * other.y, z += weight * other.z;
  xy += weight * other.xy, yz += weight * other.yz, zx += weight * other.zx;
  xyz += weight * other.xyz;
}

double Extents::copies(const std::array<double, 3>& density) const {
  const auto [i, j, k] = density;
  return 1 + x * i + y * j + z * k + xy * i * j + yz * j * k + zx * k * i + xyz * i * j * k;
}

namespace {

[[gnu::cold]] std::size_t count_bodies(const Boxes& boxes) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < boxes.count(); ++i) count += boxes[i].min[0] <= boxes[i].max[0] ? 1 : 0;
  return count;
}

[[gnu::cold]] BoxSample look_at_all(const Boxes& boxes) {
  BoxSample sample;
  const std::size_t count = count_bodies(boxes);
  if (count == 0) return sample;
  Vector<float> minima;
  minima.reserve(count);
  for (std::size_t axis = 0; axis < 3; ++axis) sample.axes[axis] = measure_axis(boxes, axis, minima);
  const Ranges ranges(sample.axes);
  Sums sums;
  for (std::size_t i = 0; i < boxes.count(); ++i) {
    if (boxes[i].min[0] <= boxes[i].max[0]) sums.add(ranges.edges(boxes[i]));
  }
  sample.extents.add(sums.extents, 1 / sums.count);
  return sample;
}

}  // namespace

BoxSample take_rough_sample(const Boxes& boxes) {
  Drawn drawn;
  draw(boxes, drawn);
  BoxSample sample;
  if (drawn.count == 0) return sample;
  sample.axes = measure_axes(drawn.view());
  sample.extents.add(sum_all(drawn.view(), Ranges(sample.axes)).extents,
                     1 / static_cast<double>(drawn.count));
  return sample;
}

BoxSample take_sample(const Boxes& boxes, Look look) {
  if (look != Look::at_few) return look_at_all(boxes);
  Drawn drawn;
  draw(boxes, drawn);
  BoxSample sample;
  if (drawn.count == 0) return sample;
  sample.axes = measure_axes(drawn.view());
  const Ranges ranges(sample.axes);
  const Float4 limits = large_edges(drawn.view(), ranges);
  const Sums usual = sum_usual(drawn.view(), ranges, limits);
  if (usual.count == static_cast<double>(drawn.count)) {
    sample.extents.add(usual.extents, 1 / usual.count);
    return sample;
  }
  const LargeBoxes large = find_large(boxes, ranges, limits);
  const auto count = static_cast<double>(large.of);
  if (usual.count > 0) sample.extents.add(usual.extents, (1 - large.sums.count / count) / usual.count);
  sample.extents.add(large.sums.extents, 1 / count);
  return sample;
}

}  // namespace cellsweep::stream
