/// @file
/// Builds a CellTree and finds all pairs on the way, each cell's while its boxes are in the cache; or
/// collects the cells whose pairs are to be found.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engines/stream/cells/cell_tree.h"

namespace cellsweep::stream {

class TreeBuilder {
 public:
  TreeBuilder(Crew& crew, const Kernels& kernels, std::span<const std::unique_ptr<Scratch>> scratches,
              std::span<const BodyFilter> filters, bool collects)
      : crew_(crew), kernels_(kernels), scratches_(scratches), filters_(filters), collects_(collects) {}

  /// Makes the topmost grid and says which boxes go into which of its cells.
  Placement place(const Boxes& boxes, Node& root);
  /// Puts them there, from one share of each list, 0 to 1, to another one.
  void fill(const Boxes& boxes, const Placement& placement, double from, double to);
  /// Makes some of the cells and finds their pairs. Each is made once.
  void finish(const Placement& placement, std::uint32_t first, std::uint32_t end, Node& root);

 private:
  void find_blocks(const Boxes& boxes, std::size_t first, std::size_t end, const GridNumbers& grid,
                   EightBlocks& blocks) const;
  std::optional<Placement> try_place(const Boxes& boxes, Look look, GridChoice choice, Node& root);
  std::optional<std::span<const BoxCopy>> list_copies(const Boxes& boxes, Share share, const Grid& grid,
                                                      std::size_t most, std::uint32_t* counts,
                                                      Arena& arena) const;
  void fill(const Boxes& boxes, std::span<const BoxCopy> copies, const CellBoxes* targets,
            std::uint32_t* places) const;
  CellBoxes* make_targets(const std::uint32_t* counts, std::uint32_t cells, Scratch& scratch) const;
  void finish_cell(const CellBoxes& target, Cell& cell, Scratch& scratch, const Level& level) const;
  void build_inside(const CellBoxes& boxes, Cell& cell, Scratch& scratch, const Level& level) const;
  bool split(const Boxes& boxes, Look look, const GridChoice& choice, Cell& cell, Scratch& scratch,
             const Level& level) const;
  void find_pairs(const CellBoxes& cell, Scratch& scratch) const;
  std::uint32_t put_static_last(const CellBoxes& cell) const;
  void keep_whole(const CellBoxes& boxes, Cell& cell, Scratch& scratch) const;

  Crew& crew_;
  const Kernels& kernels_;
  std::span<const std::unique_ptr<Scratch>> scratches_;
  std::span<const BodyFilter> filters_;
  bool collects_;
};

/// Room for `count` boxes and some more: as many as kernels with so many lanes read together.
CellBoxes new_cell(Arena& arena, std::size_t count, unsigned lanes);

}  // namespace cellsweep::stream
