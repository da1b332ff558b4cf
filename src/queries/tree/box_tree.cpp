#include "queries/tree/box_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace cellsweep::queries {
namespace {

constexpr std::size_t kAxes = 3;
constexpr std::size_t kFull = TreeNode::kBoxes;

/// A number for each axis, and one that nobody reads.
using Four [[gnu::vector_size(16)]] = float;
using FourPlaces [[gnu::vector_size(16)]] = std::int32_t;

constexpr float kNone = std::numeric_limits<float>::infinity();

Four smaller(Four a, Four b) {
  return a < b ? a : b;
}
Four larger(Four a, Four b) {
  return a > b ? a : b;
}

/// The least and the greatest of some points, by axis; or of boxes.
struct Range {
  Four low = {kNone, kNone, kNone, kNone};
  Four high = {-kNone, -kNone, -kNone, -kNone};

  void add(const Range& other) {
    low = smaller(low, other.low);
    high = larger(high, other.high);
  }
  void add(Four point) { add({point, point}); }

  /// Half of the surface of a box.
  double area() const {
    const double x = double{high[0]} - low[0];
    const double y = double{high[1]} - low[1];
    const double z = double{high[2]} - low[2];
    return x * y + y * z + z * x;
  }
};

Range range_of(const TreeEntry& entry) {
  static_assert(sizeof(TreeEntry) >= 7 * sizeof(float) && sizeof(Aabb) == 6 * sizeof(float));
  const auto* const bytes = reinterpret_cast<const std::byte*>(&entry);
  Four low;
  FourPlaces high;
  std::memcpy(&low, bytes, sizeof(low));
  std::memcpy(&high, bytes + sizeof(entry.box.min), sizeof(high));
  // A slot taken for a float is a denormal, slow to compute with.
  return {low, reinterpret_cast<Four>(high & FourPlaces{-1, -1, -1, 0})};
}

/// Half as far from zero as the middle of a box: differences of these are no larger than floats go.
Four middle_of(const Range& range) {
  return range.low * 0.25F + range.high * 0.25F;
}

/// Where the middles of boxes are, in equal steps on each axis.
class Bins {
 public:
  static constexpr std::size_t kCount = 16;

  explicit Bins(const Range& middles) : low_(middles.low) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const float length = middles.high[axis] - middles.low[axis];
      scale_[axis] = length > 0 ? kCount / length : 0;
    }
  }

  bool all_in_one(std::size_t axis) const { return scale_[axis] == 0; }

  /// The bins of a middle.
  FourPlaces of(Four middle) const {
    constexpr float kLast = kCount - 1;
    const Four place = smaller((middle - low_) * scale_, Four{kLast, kLast, kLast, kLast});
    return __builtin_convertvector(larger(place, Four{}), FourPlaces);
  }

 private:
  Four low_;
  Four scale_ = {};
};

/// Behind which bin of an axis to cut.
struct Cut {
  std::size_t axis = kAxes;  ///< kAxes: there is none
  std::int32_t last = 0;
  double cost = std::numeric_limits<double>::infinity();
};

/// What a number of boxes takes when a walk comes to them: nodes.
double nodes_for(std::size_t boxes) {
  const std::size_t nodes = (boxes + kFull - 1) / kFull;
  return static_cast<double>(nodes);
}

/// The boxes in each bin of an axis.
struct Filled {
  std::array<Range, Bins::kCount> ranges{};
  std::array<std::uint32_t, Bins::kCount> counts{};

  /// The cut for which the sides' surfaces, times what is in them, are least.
  void choose(std::size_t axis, Cut& best) const {
    std::array<double, Bins::kCount> cost_above{};
    Range sum;
    std::size_t count = 0;
    for (std::size_t bin = Bins::kCount; bin-- > 1;) {
      sum.add(ranges[bin]);
      count += counts[bin];
      cost_above[bin] = count == 0 ? 0 : sum.area() * nodes_for(count);
    }
    sum = {};
    count = 0;
    for (std::size_t bin = 0; bin + 1 < Bins::kCount; ++bin) {
      if (counts[bin] == 0) continue;
      sum.add(ranges[bin]);
      count += counts[bin];
      const double cost = sum.area() * nodes_for(count) + cost_above[bin + 1];
      if (cost < best.cost) best = {axis, static_cast<std::int32_t>(bin), cost};
    }
  }
};

/// Neighbours in the list of entries, a box around them, and where their middles are.
struct Part {
  std::span<TreeEntry> entries;
  Range range;
  Range middles;
};

Part part_of(std::span<TreeEntry> entries) {
  Part part{entries, {}, {}};
  for (const TreeEntry& entry : entries) {
    const Range range = range_of(entry);
    part.range.add(range);
    part.middles.add(middle_of(range));
  }
  return part;
}

/// The parts that become the boxes of one node.
struct Parts {
  std::array<Part, kFull> parts;
  std::size_t count = 0;
};

/// Cuts boxes in two where the surfaces of both sides become small, while a node has room for one more.
class TreeBuilder {
 public:
  explicit TreeBuilder(Vector<TreeNode>& nodes) : nodes_(nodes) {}

  void build(std::span<TreeEntry> entries) {
    nodes_.reserve(entries.size() / 4 + 1);
    nodes_.emplace_back();
    fill(0, entries, 1);
  }

 private:
  /// From here on parts are halved by number: no boxes make the tree any deeper.
  static constexpr unsigned kHalved = 24;
  static_assert(kHalved + 32 / (std::bit_width(kFull) - 1) + 1 <= kTreeDepth);

  void fill(std::uint32_t node, std::span<TreeEntry> entries, unsigned depth) {
    Parts parts = depth < kHalved ? cut_by_surface(entries) : cut_by_number(entries);
    dissolve(parts);
    std::ranges::fill(nodes_[node].faces[0], std::numeric_limits<float>::quiet_NaN());
    for (std::size_t i = 0; i < parts.count; ++i) {
      const Part& part = parts.parts[i];
      for (std::size_t axis = 0; axis < kAxes; ++axis) {
        nodes_[node].faces[axis][i] = part.range.low[axis];
        nodes_[node].faces[axis + kAxes][i] = part.range.high[axis];
      }
      if (part.entries.size() == 1) {
        nodes_[node].content[i] = part.entries[0].slot;
        nodes_[node].bodies |= 1U << i;
        continue;
      }
      const auto next = static_cast<std::uint32_t>(nodes_.size());
      nodes_[node].content[i] = next;
      nodes_.emplace_back();
      fill(next, part.entries, depth + 1);
    }
  }

  // The part with the largest surface again and again, while it is more than a node holds.
  Parts cut_by_surface(std::span<TreeEntry> entries) {
    Parts parts;
    if (entries.empty()) return parts;
    parts.parts[parts.count++] = part_of(entries);
    while (parts.count < kFull) {
      Part* const largest = find_largest(parts, [](const Part& part) { return part.range.area(); });
      if (largest == nullptr) break;
      cut(parts, *largest, place_to_cut(*largest));
    }
    return parts;
  }

  Parts cut_by_number(std::span<TreeEntry> entries) {
    Parts parts;
    parts.parts[parts.count++] = part_of(entries);
    while (parts.count < kFull) {
      const auto size = [](const Part& part) { return static_cast<double>(part.entries.size()); };
      Part* const largest = find_largest(parts, size);
      if (largest == nullptr) break;
      cut(parts, *largest, halve(*largest));
    }
    return parts;
  }

  /// Of those that do not fit into a node; null: there is none.
  template <class Measure>
  static Part* find_largest(Parts& parts, const Measure& measure) {
    Part* largest = nullptr;
    double most = -1;
    for (std::size_t i = 0; i < parts.count; ++i) {
      Part& part = parts.parts[i];
      if (part.entries.size() <= kFull || measure(part) <= most) continue;
      largest = &part;
      most = measure(part);
    }
    return largest;
  }

  static void cut(Parts& parts, Part& part, std::size_t first) {
    parts.parts[parts.count++] = part_of(part.entries.subspan(first));
    part = part_of(part.entries.first(first));
  }

  // Bodies of small parts become the node's own where it has room.
  static void dissolve(Parts& parts) {
    while (true) {
      Part* smallest = nullptr;
      for (std::size_t i = 0; i < parts.count; ++i) {
        Part& part = parts.parts[i];
        const std::size_t size = part.entries.size();
        if (size > 1 && (smallest == nullptr || size < smallest->entries.size())) smallest = &part;
      }
      if (smallest == nullptr || parts.count - 1 + smallest->entries.size() > kFull) return;
      const std::span<TreeEntry> entries = smallest->entries;
      *smallest = part_of(entries.first(1));
      for (std::size_t i = 1; i < entries.size(); ++i)
        parts.parts[parts.count++] = part_of(entries.subspan(i, 1));
    }
  }

  /// Sorts the entries of a part into two sides and returns where the second one begins.
  static std::size_t place_to_cut(const Part& part) {
    const Bins bins(part.middles);
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
    Cut best;
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if (!bins.all_in_one(axis)) filled[axis].choose(axis, best);
    }
    if (best.axis == kAxes) return part.entries.size() / 2;  // all middles are the same
    const auto is_below = [&](const TreeEntry& entry) {
      return bins.of(middle_of(range_of(entry)))[best.axis] <= best.last;
    };
    const auto second = std::partition(part.entries.begin(), part.entries.end(), is_below);
    return static_cast<std::size_t>(second - part.entries.begin());
  }

  /// The same with as many on both sides.
  static std::size_t halve(const Part& part) {
    const Four lengths = part.middles.high - part.middles.low;
    std::size_t longest = 0;
    for (std::size_t axis = 1; axis < kAxes; ++axis) {
      if (lengths[axis] > lengths[longest]) longest = axis;
    }
    const auto middle = [&](const TreeEntry& entry) { return middle_of(range_of(entry))[longest]; };
    const std::size_t half = part.entries.size() / 2;
    std::nth_element(
        part.entries.begin(), part.entries.begin() + static_cast<std::ptrdiff_t>(half), part.entries.end(),
        [&](const TreeEntry& one, const TreeEntry& other) { return middle(one) < middle(other); });
    return half;
  }

  Vector<TreeNode>& nodes_;
};

}  // namespace

void BoxTree::build(std::span<TreeEntry> entries) {
  TreeBuilder(nodes_).build(entries);
}

}  // namespace cellsweep::queries
