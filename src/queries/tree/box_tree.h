/// @file
/// A tree of the boxes that the last update saw, for questions that reach far.
#pragma once

#include <span>

#include "base/memory/memory.h"
#include "cellsweep/aabb.h"
#include "cellsweep/engine/slots.h"
#include "queries/kernels/tree_node.h"

namespace cellsweep::queries {

struct alignas(16) TreeEntry {
  Aabb box;
  Slot slot = 0;
};

/// Each body once, whatever its size. Depth and memory are bounded for any boxes: at most kTreeDepth nodes
/// above each other, and fewer of them than bodies.
class BoxTree {
 public:
  /// Of those among the boxes, by slot, that `is_there` returns true for.
  template <class IsThere>
  BoxTree(std::span<const Aabb> boxes, const IsThere& is_there) {
    Vector<TreeEntry> entries;
    entries.reserve(boxes.size());
    for (std::size_t slot = 0; slot < boxes.size(); ++slot) {
      if (is_there(static_cast<Slot>(slot))) entries.push_back({boxes[slot], static_cast<Slot>(slot)});
    }
    build(entries);
  }

  /// The first one is the topmost; there is one always.
  const TreeNode* nodes() const { return nodes_.data(); }
  std::size_t size() const { return nodes_.size(); }

 private:
  void build(std::span<TreeEntry> entries);

  Vector<TreeNode> nodes_;
};

}  // namespace cellsweep::queries
