/// @file
/// Brings changed boxes into a CellTree: only cells that a changed box was or is in are looked at.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "engines/stream/cells/cell_tree.h"

namespace cellsweep::stream {

class TreeChanger {
 public:
  TreeChanger(Pool& pool, const Kernels& kernels, std::span<const std::unique_ptr<Desk>> desks,
              const BodyId* ids)
      : pool_(pool), kernels_(kernels), desks_(desks), ids_(ids) {}

  void change(std::span<const Change> changes, Node& root);

 private:
  /// A changed body in a cell: in it before, or now, or both, and on which axes it starts there.
  struct Visit {
    std::uint32_t change = 0;
    std::uint8_t old_flags = 0;  // kThere and the flags of its tag, or 0
    std::uint8_t new_flags = 0;
  };

  static constexpr std::uint8_t kThere = 8;

  template <class Emit>
  void for_each_visit(const Visit& visit, const Grid& grid, Emit&& emit) const;
  void change_node(std::span<const Visit> visits, Node& node, Desk& desk) const;
  void change_cell(std::span<Visit> visits, Cell& cell, Desk& desk) const;
  void change_boxes(std::span<const Visit> visits, CellBoxes& cell, Desk& desk) const;
  CellBoxes copy_with_room(const CellBoxes& cell, std::uint32_t more, Arena& arena) const;
  static std::span<Visit> merge(std::span<Visit> visits);
  static Visit first_visit(const Change& change, std::size_t index);

  Pool& pool_;
  const Kernels& kernels_;
  std::span<const std::unique_ptr<Desk>> desks_;
  const BodyId* ids_;
  std::span<const Change> changes_;
};

}  // namespace cellsweep::stream
