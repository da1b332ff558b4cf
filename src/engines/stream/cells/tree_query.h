/// @file
/// Asks a CellTree which of its boxes one box overlaps.
#pragma once

#include <cstdint>

#include "engines/stream/cells/cell_tree.h"

namespace cellsweep::stream {

class TreeQuery {
 public:
  TreeQuery(const Kernels& kernels, KeyBuffer& slots) : kernels_(kernels), slots_(slots) {}

  /// Appends the slots of the boxes that this one overlaps, each once.
  void find(const Aabb& box, const Node& root) { find_inside({box, kWholeFlags << kSlotBits, 0}, root); }

  /// Boxes that it was compared with.
  std::uint64_t tests() const { return tests_; }

 private:
  void find_inside(const TaggedBox& box, const Node& node);

  const Kernels& kernels_;
  KeyBuffer& slots_;
  std::uint64_t tests_ = 0;
};

}  // namespace cellsweep::stream
