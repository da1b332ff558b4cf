/// @file
/// The kernels of queries for any vector: `Lanes` says how wide it is, gathers and compares.
///
/// As in the kernels of engine `stream`, whatever these call has internal linkage and nothing of it is the
/// standard library's: engines/stream/kernels/body.h says why.
///
/// Rounding: an operation is off by 2^-24 of its result, and at most six follow each other, so what is
/// compared is made smaller or larger by 2^-19 of itself. That a number overflows, or is too small for a
/// normal one, must make no box be missed either: what is too large is taken to be kLargest, and kSmallest is
/// added.
#pragma once

#include "cellsweep/engine/cell_boxes.h"
#include "queries/kernels/kernel.h"

namespace cellsweep::queries {
namespace {

inline constexpr float kSmaller = 1 - 0x1p-19F;
inline constexpr float kLarger = 1 + 0x1p-19F;
inline constexpr float kLargest = 1e38F;
inline constexpr float kSmallest = 1e-37F;

template <class Lanes>
using VectorOf = typename Lanes::Vector;

template <class Lanes>
VectorOf<Lanes> all(float value) {
  return value - VectorOf<Lanes>{};
}

// Where an operand is NaN, the second one is the result.
template <class Vector>
Vector larger(Vector a, Vector b) {
  return a > b ? a : b;
}
template <class Vector>
Vector smaller(Vector a, Vector b) {
  return a < b ? a : b;
}

/// Calls `test(faces)` with each vector of boxes and appends the places of the lanes that it returns.
template <class Lanes, class Test>
std::uint32_t find_places(const BoxRow& row, std::uint32_t* places, const Test& test) {
  std::uint32_t found = 0;
  for (std::uint32_t first = 0; first < row.count; first += Lanes::kCount) {
    VectorOf<Lanes> faces[6];
    Lanes::gather(row.first + first * row.step, row.step, faces);
    const std::uint32_t lanes = test(faces) & Lanes::lanes_below(row.count - first);
    found += Lanes::put_places(lanes, first, places + found);
  }
  return found;
}

/// A box in all lanes.
template <class Lanes>
struct OverlapLanes {
  VectorOf<Lanes> low[3], high[3];

  explicit OverlapLanes(const Aabb& box) {
    const auto* const face = reinterpret_cast<const float*>(&box);
    for (unsigned axis = 0; axis < 3; ++axis) {
      low[axis] = all<Lanes>(face[axis]);
      high[axis] = all<Lanes>(face[axis + 3]);
    }
  }

  /// A bit for each lane whose box overlaps it.
  std::uint32_t test(const VectorOf<Lanes> (&faces)[6]) const {
    auto meets = Lanes::less_equal(faces[0], high[0]);
    meets = meets & Lanes::less_equal(low[0], faces[3]);
    for (unsigned axis = 1; axis < 3; ++axis) {
      meets = meets & Lanes::less_equal(faces[axis], high[axis]);
      meets = meets & Lanes::less_equal(low[axis], faces[axis + 3]);
    }
    return Lanes::bits(meets);
  }
};

template <class Lanes>
std::uint32_t find_overlaps(const BoxRow& row, const Aabb& box, std::uint32_t* places) {
  const OverlapLanes<Lanes> lanes(box);
  return find_places<Lanes>(row, places, [&](const auto& faces) { return lanes.test(faces); });
}

/// The numbers of a path in all lanes.
template <class Lanes>
struct CastLanes {
  VectorOf<Lanes> from_min[3], from_max[3], inverse[3], wide[3], low[3], high[3];
  VectorOf<Lanes> end;

  explicit CastLanes(const CastNumbers& path) : end(all<Lanes>(path.end)) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      from_min[axis] = all<Lanes>(path.from_min[axis]);
      from_max[axis] = all<Lanes>(path.from_max[axis]);
      inverse[axis] = all<Lanes>(path.inverse[axis]);
      wide[axis] = all<Lanes>(path.wide[axis]);
      low[axis] = all<Lanes>(path.low[axis]);
      high[axis] = all<Lanes>(path.high[axis]);
    }
  }

  /// A bit for each lane whose box the path may touch, and when it does at the earliest. `kFlat`: there may
  /// be an axis along which the path does not move.
  template <bool kFlat>
  std::uint32_t test(const VectorOf<Lanes> (&faces)[6], VectorOf<Lanes>& enter) const {
    using Vector = VectorOf<Lanes>;
    enter = Vector{};
    Vector leave = end;
    auto meets = Lanes::less_equal(faces[0], faces[3]);
    for (unsigned axis = 0; axis < 3; ++axis) {
      const Vector a = (faces[axis] - from_min[axis]) * inverse[axis];
      const Vector b = (faces[axis + 3] - from_max[axis]) * inverse[axis];
      Vector first = smaller(a, b);
      Vector last = larger(a, b);
      if (kFlat) {
        first = first - wide[axis];
        last = last + wide[axis];
        meets = meets & Lanes::less_equal(faces[axis], high[axis]);
        meets = meets & Lanes::less_equal(low[axis], faces[axis + 3]);
      }
      enter = larger(first, enter);
      leave = smaller(last, leave);
    }
    enter = smaller(enter, all<Lanes>(kLargest)) * kSmaller;
    return Lanes::bits(meets & Lanes::less_equal(enter, leave * kLarger + kSmallest));
  }
};

template <class Lanes, bool kFlat>
std::uint32_t find_on_path(const BoxRow& row, const CastNumbers& path, std::uint32_t* places) {
  const CastLanes<Lanes> lanes(path);
  return find_places<Lanes>(row, places, [&](const auto& faces) {
    VectorOf<Lanes> enter;
    return lanes.template test<kFlat>(faces, enter);
  });
}

template <class Lanes>
std::uint32_t find_on_path(const BoxRow& row, const CastNumbers& path, std::uint32_t* places) {
  return path.is_flat ? find_on_path<Lanes, true>(row, path, places)
                      : find_on_path<Lanes, false>(row, path, places);
}

/// The numbers of a near question in all lanes.
template <class Lanes>
struct NearLanes {
  VectorOf<Lanes> min[3], max[3];
  VectorOf<Lanes> most;

  explicit NearLanes(const NearNumbers& question) : most(all<Lanes>(question.most)) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      min[axis] = all<Lanes>(question.min[axis]);
      max[axis] = all<Lanes>(question.max[axis]);
    }
  }

  /// A bit for each lane whose box is near enough, and no more than the square of its distance.
  std::uint32_t test(const VectorOf<Lanes> (&faces)[6], VectorOf<Lanes>& square) const {
    using Vector = VectorOf<Lanes>;
    square = Vector{};
    for (unsigned axis = 0; axis < 3; ++axis) {
      const Vector gap = larger(faces[axis] - max[axis], min[axis] - faces[axis + 3]);
      const Vector there = larger(gap, Vector{});
      square = square + there * there;
    }
    square = smaller(square, all<Lanes>(kLargest)) * kSmaller;
    return Lanes::bits(Lanes::less_equal(faces[0], faces[3]) & Lanes::less_equal(square, most));
  }
};

inline std::uint64_t near_key(float square, std::uint32_t place) {
  return std::uint64_t{__builtin_bit_cast(std::uint32_t, square)} << 32 | place;
}

template <class Lanes>
std::uint32_t find_near(const BoxRow& row, const NearNumbers& question, std::uint64_t* keys) {
  const NearLanes<Lanes> question_lanes(question);
  std::uint32_t found = 0;
  for (std::uint32_t first = 0; first < row.count; first += Lanes::kCount) {
    VectorOf<Lanes> faces[6];
    VectorOf<Lanes> square;
    Lanes::gather(row.first + first * row.step, row.step, faces);
    std::uint32_t lanes = question_lanes.test(faces, square) & Lanes::lanes_below(row.count - first);
    for (; lanes != 0; lanes &= lanes - 1) {
      const auto lane = static_cast<unsigned>(__builtin_ctz(lanes));
      const float lower = square[lane];  // clang 14 casts the bits of the first lane, if not of a copy
      keys[found++] = near_key(lower, first + Lanes::place_of(lane));
    }
  }
  return found;
}

/// Nodes of a tree to be looked at, those with the least `key` last among those of one node.
class WaitingNodes {
 public:
  explicit WaitingNodes(const TreeNode* nodes) : nodes_(nodes) { add(0, 0); }

  /// What is added from now on is in order.
  void begin_node() { first_ = count_; }
  void add(float key, std::uint32_t node) {
    prefetch(nodes_ + node);
    unsigned place = count_++;
    for (; place > first_ && waiting_[place - 1].key < key; --place) waiting_[place] = waiting_[place - 1];
    waiting_[place] = {key, node};
  }
  /// Takes the last one whose key is at most that; null: there is none.
  const TreeNode* take(float most) {
    while (count_ > 0) {
      const Waiting& last = waiting_[--count_];
      if (last.key <= most) return nodes_ + last.node;
    }
    return nullptr;
  }

 private:
  struct Waiting {
    float key;
    std::uint32_t node;
  };

  static void prefetch(const TreeNode* node) {
    for (unsigned line = 0; line < sizeof(TreeNode); line += 64)
      __builtin_prefetch(reinterpret_cast<const char*>(node) + line);
  }

  const TreeNode* nodes_;
  Waiting waiting_[kWaitingNodes];  // NOLINT(*-member-init): as far as it is read
  unsigned count_ = 0;
  unsigned first_ = 0;
};

/// Tests the boxes of a node: a bit for each that passes `test(faces, key)`, and their keys.
template <class Lanes, class Test>
std::uint32_t test_node(const TreeNode& node, float (&keys)[TreeNode::kBoxes], const Test& test) {
  std::uint32_t bits = 0;
  for (unsigned first = 0; first < TreeNode::kBoxes; first += Lanes::kCount) {
    VectorOf<Lanes> faces[6];
    for (unsigned face = 0; face < 6; ++face)
      __builtin_memcpy(&faces[face], node.faces[face] + first, sizeof(faces[face]));
    VectorOf<Lanes> key;
    bits |= test(faces, key) << first;
    __builtin_memcpy(keys + first, &key, sizeof(key));
  }
  return bits;
}

/// Nodes whose bits are set wait.
inline void wait_for(const TreeNode& node, std::uint32_t bits, const float (&keys)[TreeNode::kBoxes],
                     WaitingNodes& waiting) {
  waiting.begin_node();
  for (bits &= ~node.bodies; bits != 0; bits &= bits - 1) {
    const auto lane = static_cast<unsigned>(__builtin_ctz(bits));
    waiting.add(keys[lane], node.content[lane]);
  }
}

template <class Lanes>
void walk_tree_for_overlaps(const TreeNode* nodes, const Aabb& box, const TakeBodies& take) {
  const OverlapLanes<Lanes> lanes(box);
  WaitingNodes waiting(nodes);
  float keys[TreeNode::kBoxes];
  while (const TreeNode* const node = waiting.take(0)) {
    const std::uint32_t bits = test_node<Lanes>(*node, keys, [&](const auto& faces, VectorOf<Lanes>& key) {
      key = VectorOf<Lanes>{};
      return lanes.test(faces);
    });
    wait_for(*node, bits, keys, waiting);
    if ((bits & node->bodies) != 0 && !take.take(take.self, *node, bits & node->bodies)) return;
  }
}

template <class Lanes, bool kFlat>
void walk_tree_on_path(const TreeNode* nodes, const CastNumbers& path, const TakeBodies& take) {
  CastLanes<Lanes> lanes(path);
  WaitingNodes waiting(nodes);
  float keys[TreeNode::kBoxes];
  while (const TreeNode* const node = waiting.take(path.end * kLarger + kSmallest)) {
    const std::uint32_t bits = test_node<Lanes>(*node, keys, [&](const auto& faces, VectorOf<Lanes>& key) {
      return lanes.template test<kFlat>(faces, key);
    });
    wait_for(*node, bits, keys, waiting);
    if ((bits & node->bodies) == 0) continue;
    if (!take.take(take.self, *node, bits & node->bodies)) return;
    lanes.end = all<Lanes>(path.end);
  }
}

template <class Lanes>
void walk_tree_for_near(const TreeNode* nodes, const NearNumbers& question, const TakeNearBodies& take) {
  NearLanes<Lanes> lanes(question);
  WaitingNodes waiting(nodes);
  float squares[TreeNode::kBoxes];
  while (const TreeNode* const node = waiting.take(question.most)) {
    const std::uint32_t bits = test_node<Lanes>(
        *node, squares,
        [&](const auto& faces, VectorOf<Lanes>& square) { return lanes.test(faces, square); });
    wait_for(*node, bits, squares, waiting);
    std::uint64_t keys[TreeNode::kBoxes];
    std::uint32_t found = 0;
    for (std::uint32_t bodies = bits & node->bodies; bodies != 0; bodies &= bodies - 1) {
      const auto lane = static_cast<unsigned>(__builtin_ctz(bodies));
      keys[found++] = near_key(squares[lane], lane);
    }
    if (found == 0) continue;
    if (!take.take(take.self, *node, keys, found)) return;
    lanes.most = all<Lanes>(question.most);
  }
}

/// What lanes in the order of the boxes have in common.
template <unsigned kLanes>
struct LanesInOrder {
  static constexpr unsigned kCount = kLanes;

  /// A bit for each lane below `count`.
  static std::uint32_t lanes_below(std::uint32_t count) {
    return count >= kCount ? (1U << kCount) - 1 : (1U << count) - 1;
  }
  /// The place in the vector of a lane's box.
  static std::uint32_t place_of(unsigned lane) { return lane; }
  static std::uint32_t put_places(std::uint32_t lanes, std::uint32_t first, std::uint32_t* places) {
    std::uint32_t count = 0;
    for (; lanes != 0; lanes &= lanes - 1)
      places[count++] = first + static_cast<unsigned>(__builtin_ctz(lanes));
    return count;
  }
};

inline bool is_tagged(const BoxRow& row) {
  return row.step == sizeof(stream::TaggedBox);
}

/// `Tagged` are the lanes for boxes of cells, `Plain` for others, `Nodes` for those of a tree's nodes.
template <class Tagged, class Plain, class Nodes>
constexpr QueryKernels make_query_kernels(VectorIsa isa) {
  static_assert(Tagged::kCount <= kMostLanes && kRowBoxes % Tagged::kCount == 0);
  return {isa,
          [](const BoxRow& row, const Aabb& box, std::uint32_t* places) {
            return is_tagged(row) ? find_overlaps<Tagged>(row, box, places)
                                  : find_overlaps<Plain>(row, box, places);
          },
          [](const BoxRow& row, const CastNumbers& path, std::uint32_t* places) {
            return is_tagged(row) ? find_on_path<Tagged>(row, path, places)
                                  : find_on_path<Plain>(row, path, places);
          },
          [](const BoxRow& row, const NearNumbers& question, std::uint64_t* keys) {
            return is_tagged(row) ? find_near<Tagged>(row, question, keys)
                                  : find_near<Plain>(row, question, keys);
          },
          walk_tree_for_overlaps<Nodes>,
          [](const TreeNode* nodes, const CastNumbers& path, const TakeBodies& take) {
            if (path.is_flat) {
              walk_tree_on_path<Nodes, true>(nodes, path, take);
            } else {
              walk_tree_on_path<Nodes, false>(nodes, path, take);
            }
          },
          walk_tree_for_near<Nodes>};
}

}  // namespace
}  // namespace cellsweep::queries
