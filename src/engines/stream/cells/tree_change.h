/// @file
/// Brings changed boxes into a CellTree, and finds the pairs that they have: only cells that a changed box
/// was or is in are looked at.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "engines/stream/cells/cell_places.h"
#include "engines/stream/cells/cell_tree.h"

namespace cellsweep::stream {

class TreeChanger {
 public:
  TreeChanger(Crew& crew, const Kernels& kernels, std::span<const std::unique_ptr<Scratch>> scratches)
      : crew_(crew), kernels_(kernels), scratches_(scratches) {}

  void change(std::span<const FatBoxChange> changes, Node& root);
  void change_one(const FatBoxChange& change, Node& root);

 private:
  /// A changed body in a cell: in it before, or now, or both, and on which axes it starts there.
  struct Visit {
    std::uint32_t change = 0;
    std::uint8_t old_flags = 0;  // kThere and the flags of its tag, or 0
    std::uint8_t new_flags = 0;
  };

  static constexpr std::uint8_t kThere = 8;
  static bool enters(const Visit& visit) { return visit.old_flags == 0; }
  struct CellVisit {
    std::uint32_t cell;
    Visit visit;
  };

  /// The cells of a grid that it was in and is in.
  struct Blocks {
    CellBlock was;
    CellBlock is;
  };

  Blocks blocks_of(const Visit& visit, const Grid& grid) const;
  static bool is_of_one_block(const Visit& visit, const Blocks& blocks);
  [[gnu::noinline]] static void count_visits(const Visit& visit, const Blocks& blocks, const Grid& grid,
                                             CellPlaces::OfWorker places);
  [[gnu::noinline]] static void put_visits(const Visit& visit, const Blocks& blocks, const Grid& grid,
                                           CellPlaces::OfWorker places, Visit* to);
  template <class Emit>
  static void for_each_visit(const Visit& visit, const Blocks& blocks, const Grid& grid, Emit&& emit);
  void change_node(std::span<const Visit> visits, Node& node, Scratch& scratch) const;
  [[gnu::noinline]] void change_cell(std::span<Visit> visits, Cell& cell, Scratch& scratch) const;
  void change_boxes(std::span<const Visit> visits, CellBoxes& cell, Scratch& scratch) const;
  void make_room(CellBoxes& cell, std::uint32_t more, Scratch& scratch) const;
  static std::span<Visit> merge(std::span<Visit> visits);
  static Visit first_visit(const FatBoxChange& change, std::size_t index);
  [[gnu::noinline]] static std::size_t list_cells(const FatBoxChange& change, const Blocks& blocks,
                                                  const Grid& grid, CellVisit* list);

  Crew& crew_;
  const Kernels& kernels_;
  std::span<const std::unique_ptr<Scratch>> scratches_;
  std::span<const FatBoxChange> changes_;
  bool finds_pairs_ = true;
};

}  // namespace cellsweep::stream
