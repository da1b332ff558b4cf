#include "queries/tree/binary_tree.h"

#include <limits>

#include "queries/tree/cut.h"

namespace cellsweep::queries {

BinaryTree::BinaryTree(std::span<TreeEntry> entries) {
  nodes_.reserve(entries.size() / 4 + 1);
  add(0, entries.size());
  cut(entries, 0, 1);
}

void BinaryTree::add(std::uint32_t first, std::size_t count) {
  nodes_.emplace_back();
  nodes_.back().first = first;
  nodes_.back().count = static_cast<std::uint32_t>(count);
}

void BinaryTree::cut(std::span<TreeEntry> all, std::uint32_t number, unsigned depth) {
  const std::uint32_t first = nodes_[number].first;
  const Part part = part_of(all.subspan(first, nodes_[number].count));
  const std::size_t count = part.entries.size();
  nodes_[number].range = part.range;
  if (count <= BinaryNode::kPlaces) {
    for (std::size_t i = 0; i + 1 < count; ++i) nodes_[number].costs[i] = part.range.weight();
    return;
  }
  const std::size_t on_first = depth < kCutBySurface ? cut_by_surface(part) : cut_by_number(part);
  const auto sides = static_cast<std::uint32_t>(nodes_.size());
  nodes_[number].sides = sides;
  add(first, on_first);
  add(first + static_cast<std::uint32_t>(on_first), count - on_first);
  cut(all, sides, depth + 1);
  cut(all, sides + 1, depth + 1);
  share_places(nodes_[number]);
}

void BinaryTree::share_places(BinaryNode& node) const {
  const std::array<double, BinaryNode::kPlaces>& one = nodes_[node.sides].costs;
  const std::array<double, BinaryNode::kPlaces>& other = nodes_[node.sides + 1].costs;
  node.costs[0] = std::numeric_limits<double>::infinity();
  for (std::size_t last = 1; last < BinaryNode::kPlaces; ++last) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < last; ++i) {
      if (one[i] + other[last - 1 - i] < one[best] + other[last - 1 - best]) best = i;
    }
    node.costs[last] = one[best] + other[last - 1 - best];
    node.first_gets[last] = static_cast<std::uint8_t>(best + 1);
  }
  node.first_of_all = node.first_gets.back();
  const double alone = node.range.weight() + node.costs.back();
  for (std::size_t last = 0; last < BinaryNode::kPlaces; ++last) {
    if (node.costs[last] <= alone) continue;
    node.costs[last] = alone;
    node.first_gets[last] = 0;
  }
}

}  // namespace cellsweep::queries
