#include "queries/tree/cut.h"

#include <algorithm>
#include <array>
#include <limits>

namespace cellsweep::queries {
namespace {

/// Where the middles of boxes are, in equal steps on each axis.
class Bins {
 public:
  static constexpr std::size_t kMost = 32;

  /// For so many boxes.
  Bins(const Range& middles, std::size_t boxes)
      : count_(boxes < kFew ? kMost / 2 : kMost), low_(middles.low) {
    const auto steps = static_cast<float>(count_);
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const float length = middles.high[axis] - middles.low[axis];
      scale_[axis] = length > 0 ? steps / length : 0;
    }
  }

  std::size_t count() const { return count_; }
  bool all_in_one(std::size_t axis) const { return scale_[axis] == 0; }

  /// The bins of a middle.
  FourPlaces of(Four middle) const {
    const auto last = static_cast<float>(count_ - 1);
    const Four place = smaller((middle - low_) * scale_, Four{last, last, last, last});
    return __builtin_convertvector(larger(place, Four{}), FourPlaces);
  }

 private:
  /// EPYC, 100,000 boxes: with half as many bins below it the tree is made in an eighth less time, and as
  /// good; with half as many everywhere questions about what is nearest take a twentieth more.
  static constexpr std::size_t kFew = 128;

  std::size_t count_;
  Four low_;
  Four scale_ = {};
};

/// Behind which bin of an axis to cut.
struct BestCut {
  std::size_t axis = kAxes;  ///< kAxes: there is none
  std::int32_t last = 0;
  double cost = std::numeric_limits<double>::infinity();
};

/// What a number of boxes takes when a walk comes to them: nodes.
double nodes_for(std::size_t boxes) {
  const std::size_t nodes = (boxes + TreeNode::kBoxes - 1) / TreeNode::kBoxes;
  return static_cast<double>(nodes);
}

/// The boxes in each bin of an axis.
struct Filled {
  std::array<Range, Bins::kMost> ranges{};
  std::array<std::uint32_t, Bins::kMost> counts{};

  /// The cut for which the sides' weights, times what is in them, are least.
  void choose(std::size_t axis, std::size_t bins, BestCut& best) const {
    std::array<double, Bins::kMost> cost_above{};
    Range sum;
    std::size_t count = 0;
    double cost = 0;
    for (std::size_t bin = bins; bin-- > 1;) {
      if (counts[bin] != 0) {
        sum.add(ranges[bin]);
        count += counts[bin];
        cost = sum.weight() * nodes_for(count);
      }
      cost_above[bin] = cost;
    }
    sum = {};
    count = 0;
    for (std::size_t bin = 0; bin + 1 < bins; ++bin) {
      if (counts[bin] == 0) continue;
      sum.add(ranges[bin]);
      count += counts[bin];
      cost = sum.weight() * nodes_for(count) + cost_above[bin + 1];
      if (cost < best.cost) best = {axis, static_cast<std::int32_t>(bin), cost};
    }
  }
};

}  // namespace

Part part_of(std::span<TreeEntry> entries) {
  Part part{entries, {}, {}};
  for (const TreeEntry& entry : entries) {
    const Range range = range_of(entry);
    part.range.add(range);
    part.middles.add(middle_of(range));
  }
  return part;
}

std::size_t cut_by_surface(const Part& part) {
  const Bins bins(part.middles, part.entries.size());
  std::array<Filled, kAxes> filled;
  for (const TreeEntry& entry : part.entries) {
    const Range range = range_of(entry);
    const FourPlaces places = bins.of(middle_of(range));
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const auto bin = static_cast<std::size_t>(places[axis]);
      filled[axis].ranges[bin].add(range);
      ++filled[axis].counts[bin];
    }
  }
  BestCut best;
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (!bins.all_in_one(axis)) filled[axis].choose(axis, bins.count(), best);
  }
  if (best.axis == kAxes) return part.entries.size() / 2;  // all middles are the same
  const auto is_below = [&](const TreeEntry& entry) {
    return bins.of(middle_of(range_of(entry)))[best.axis] <= best.last;
  };
  const auto second = std::partition(part.entries.begin(), part.entries.end(), is_below);
  return static_cast<std::size_t>(second - part.entries.begin());
}

std::size_t cut_by_number(const Part& part) {
  const Four lengths = part.middles.high - part.middles.low;
  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < kAxes; ++axis) {
    if (lengths[axis] > lengths[longest]) longest = axis;
  }
  const auto middle = [&](const TreeEntry& entry) { return middle_of(range_of(entry))[longest]; };
  const std::size_t half = part.entries.size() / 2;
  std::nth_element(part.entries.begin(), part.entries.begin() + static_cast<std::ptrdiff_t>(half),
                   part.entries.end(),
                   [&](const TreeEntry& one, const TreeEntry& other) { return middle(one) < middle(other); });
  return half;
}

}  // namespace cellsweep::queries
