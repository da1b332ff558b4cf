/// @file
/// A look at each node of a tree of boxes.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <span>
#include <vector>

#include "queries/tree/box_tree.h"

namespace cellsweep::queries {

/// Walks through all of a tree: each box must be the body's, or the one around the node's own.
class TreeCheck {
 public:
  TreeCheck(const BoxTree& tree, std::span<const Aabb> boxes) : tree_(tree), boxes_(boxes) {
    times_.assign(boxes.size(), 0);
    check(0, 1);
  }

  const std::vector<int>& times() const { return times_; }
  std::size_t nodes() const { return nodes_; }
  unsigned depth() const { return depth_; }

 private:
  static Aabb box_in(const TreeNode& node, unsigned place) {
    Aabb box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = node.faces[axis][place];
      box.max[axis] = node.faces[axis + 3][place];
    }
    return box;
  }

  // Returns the box around the node.
  Aabb check(std::uint32_t number, unsigned depth) {
    ++nodes_;
    depth_ = std::max(depth_, depth);
    const TreeNode& node = tree_.nodes()[number];
    Aabb around = {{FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX}};
    for (unsigned place = 0; place < TreeNode::kBoxes; ++place) {
      const Aabb box = box_in(node, place);
      if (!(box.min[0] <= box.max[0])) continue;
      if ((node.bodies >> place & 1) != 0) {
        ++times_[node.content[place]];
        EXPECT_EQ(box, boxes_[node.content[place]]);
      } else {
        EXPECT_EQ(box, check(node.content[place], depth + 1));
      }
      for (std::size_t axis = 0; axis < 3; ++axis) {
        around.min[axis] = std::min(around.min[axis], box.min[axis]);
        around.max[axis] = std::max(around.max[axis], box.max[axis]);
      }
    }
    return around;
  }

  const BoxTree& tree_;
  std::span<const Aabb> boxes_;
  std::vector<int> times_;
  std::size_t nodes_ = 0;
  unsigned depth_ = 0;
};

}  // namespace cellsweep::queries
