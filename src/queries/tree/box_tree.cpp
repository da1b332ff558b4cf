#include "queries/tree/box_tree.h"

#include <algorithm>
#include <limits>

#include "queries/tree/binary_tree.h"

namespace cellsweep::queries {
namespace {

/// Makes the nodes that a binary tree says are best.
class NodeFiller {
 public:
  NodeFiller(const BinaryTree& cuts, std::span<const TreeEntry> entries, Vector<TreeNode>& nodes)
      : cuts_(cuts), entries_(entries), nodes_(nodes) {}

  void fill() { fill(add_node(), cuts_[0]); }

 private:
  /// The places of a node that is being filled.
  struct Filling {
    std::uint32_t node;
    unsigned place = 0;
  };

  std::uint32_t add_node() {
    const auto number = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    std::ranges::fill(nodes_.back().faces[0], std::numeric_limits<float>::quiet_NaN());
    return number;
  }

  void fill(std::uint32_t number, const BinaryNode& from) {
    Filling filling{number};
    if (from.fits()) return put_bodies(filling, from);
    put(filling, cuts_[from.sides], from.first_of_all);
    put(filling, cuts_[from.sides + 1], BinaryNode::kPlaces - from.first_of_all);
  }

  void put(Filling& filling, const BinaryNode& from, unsigned places) {
    if (from.fits() && from.count <= places) return put_bodies(filling, from);
    const unsigned first = from.first_gets[places - 1];
    if (first == 0) {
      const std::uint32_t next = add_node();
      put_box(filling, from.range, next);
      return fill(next, from);
    }
    put(filling, cuts_[from.sides], first);
    put(filling, cuts_[from.sides + 1], places - first);
  }

  void put_bodies(Filling& filling, const BinaryNode& from) {
    for (const TreeEntry& entry : entries_.subspan(from.first, from.count)) {
      nodes_[filling.node].bodies |= 1U << filling.place;
      put_box(filling, range_of(entry), entry.slot);
    }
  }

  void put_box(Filling& filling, const Range& range, std::uint32_t content) {
    TreeNode& node = nodes_[filling.node];
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      node.faces[axis][filling.place] = range.low[axis];
      node.faces[axis + kAxes][filling.place] = range.high[axis];
    }
    node.content[filling.place++] = content;
  }

  const BinaryTree& cuts_;
  std::span<const TreeEntry> entries_;
  Vector<TreeNode>& nodes_;
};

}  // namespace

void BoxTree::build(std::span<TreeEntry> entries) {
  const BinaryTree cuts(entries);
  nodes_.reserve(entries.size() / 8 + 1);
  NodeFiller(cuts, entries, nodes_).fill();
}

}  // namespace cellsweep::queries
