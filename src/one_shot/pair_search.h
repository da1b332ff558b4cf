/// @file
/// The search behind the one-shot functions: boxes come into cells, small enough to compare all in one with
/// all.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "base/memory/array.h"
#include "base/threads/crew.h"
#include "engines/stream/cells/cell_tree.h"
#include "engines/stream/cells/keys.h"
#include "engines/stream/kernels/kernel.h"
#include "one_shot/box_set.h"
#include "one_shot/kernels/cross.h"
#include "one_shot/outlet.h"

namespace cellsweep::one_shot {

class PairSearch {
 public:
  /// Brings the boxes into cells, by as many workers of the crew as pay; these stay its active ones.
  PairSearch(Crew& crew, const stream::Kernels& kernels, const SearchedBoxes& boxes);
  PairSearch(const PairSearch&) = delete;
  PairSearch& operator=(const PairSearch&) = delete;
  ~PairSearch();

  /// Writes all pairs: by the crew, an outlet for each active worker.
  void find(std::span<const std::unique_ptr<Outlet>> outlets);

  /// By the caller alone, who gets those of a cell before the next one is looked at.
  void find(Outlet& outlet);

 private:
  class Collector;

  bool sweep();
  void make_one_cell();
  void make_pieces();
  void make_tree();
  void note_time();
  stream::CellBoxes* add_cells(std::size_t cells, std::size_t boxes);
  void find_in(const stream::CellBoxes& cell, Outlet& outlet) const;

  Crew& crew_;
  const stream::Kernels& kernels_;
  const CrossKernel cross_;
  const SearchedBoxes& boxes_;
  Array<BodyFilter> sets_;           // of those that are swept
  stream::Keys swept_;               // found already, in the place of cells
  Array<stream::TaggedBox> tagged_;  // of cells without a tree
  Array<stream::CellBoxes> made_;    // those
  std::unique_ptr<Collector> collector_;
  std::unique_ptr<stream::CellTree> tree_;
  WorkCost::Clock::time_point started_;                    // when it began to make the tree
  std::vector<std::span<const stream::CellBoxes>> cells_;  // in lists
};

}  // namespace cellsweep::one_shot
