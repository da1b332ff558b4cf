#include "engines/stream/cells/tree_query.h"

namespace cellsweep::stream {

// On which axes the box starts in a cell within cells: in all of them.
void TreeQuery::find_inside(const TaggedBox& box, const Node& node) {
  const std::uint32_t outer = box.tag >> kSlotBits;
  node.grid.for_each_cell(node.grid.block_of(box.box), [&](std::uint32_t index, std::uint32_t inner) {
    const Cell& cell = node.cells[index];
    const TaggedBox here{box.box, (outer & inner) << kSlotBits, 0};
    if (cell.node != nullptr) return find_inside(here, *cell.node);
    kernels_.partners(cell.boxes, here, slots_);
    tests_ += cell.boxes.count;
  });
}

}  // namespace cellsweep::stream
