/// @file
/// The cells of engine `stream`: grids in grids, whose innermost cells hold copies of the boxes that reach
/// into them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/memory/arena.h"
#include "base/memory/memory.h"
#include "base/sorting/pair_sort.h"
#include "base/threads/crew.h"
#include "base/tuning.h"
#include "cellsweep/aabb.h"
#include "engines/stream/bodies/fat_boxes.h"
#include "engines/stream/cells/grid.h"
#include "engines/stream/cells/keys.h"
#include "engines/stream/kernels/kernel.h"

namespace cellsweep::stream {

struct Node;
class PieceFinder;
class TreeBuilder;

/// Either boxes or, when they were too many, another grid.
struct Cell {
  CellBoxes boxes;
  Node* node = nullptr;
};

/// A grid and its cells.
struct Node {
  Grid grid;
  Cell* cells = nullptr;
};

/// A box on its way into a cell: its place in the list of boxes, the cell, and above that the flags to be
/// left in its tag.
struct BoxCopy {
  std::uint32_t box;
  std::uint32_t cell_and_flags;
};

/// A grid among the grids that it is in: how many these are, and into how many of its cells its boxes may
/// still reach, in the mean.
struct Level {
  unsigned depth = 0;
  double most_copies = tuning::kMostCopies;

  /// That of the cells of a grid in which so many boxes have so many copies.
  Level inside(std::size_t copies, std::size_t boxes) const {
    const double each = static_cast<double>(copies) / static_cast<double>(std::max(boxes, std::size_t{1}));
    return {depth + 1, std::max(most_copies / std::max(each, 1.0), tuning::kMoreCopies)};
  }
};

/// Which boxes go into which cells of the topmost grid, while a tree is built.
struct Placement {
  std::vector<std::span<const BoxCopy>> copies;  ///< as several workers listed them
  std::vector<std::uint32_t*> places;            ///< where each list's next box goes, by cell
  const CellBoxes* cells = nullptr;              ///< where the boxes of a cell go
  Level inside;                                  ///< that of these cells
};

/// Thrown where changes, or questions, would take more than to make the tree anew.
struct TooMuchWork {};

/// What one worker writes.
struct alignas(64) Scratch {
  Arena cells;                                    // of the tree, kept until the next build
  Arena job;                                      // of the job at hand
  Vector<CellBoxes> collected;                    // for a PieceFinder
  Keys found;                                     // by the last build
  Keys touched;                                   // by the last change
  std::uint64_t copies = 0;                       // boxes that this worker put into cells
  std::uint64_t tests = 0;                        // comparisons of two boxes, since it was made
  std::uint64_t most_copies = ~std::uint64_t{0};  // in this update; more are TooMuchWork
  std::uint64_t most_tests = ~std::uint64_t{0};
};

/// Bodies' boxes in space, and the pairs among them, as keys of slots.
///
/// The work is cut by the topmost grid: its cells, pieces of some hundred to a thousand boxes, go to
/// whichever worker is free, and one worker does all that happens inside of one.
class CellTree {
 public:
  /// `finder` finds the pairs of build(); null for the kernels to do so.
  [[gnu::cold]] CellTree(Crew& crew, const Kernels& kernels, PieceFinder* finder = nullptr);

  /// No cells and no pairs; of the memory, what little the next build begins with is kept.
  void clear();

  /// The cells stay; memory for work and what was found goes back.
  [[gnu::cold]] void give_back();

  /// From now on pairs must be allowed by these filters, by slot, which stay where they are until the next
  /// call of allow(); none: all are. find_partners() does not ask for them.
  void allow(std::span<const BodyFilter> filters);
  std::span<const BodyFilter> filters() const { return filters_; }

  /// From now on build() and change() may throw TooManyPairs when they find more than this.
  void limit_pairs(std::size_t most);

  /// Makes the tree anew for boxes by slot (NaN where there is no body) and finds all pairs: found().
  void build(const Boxes& boxes);

  /// The same in parts: says into which cells of the topmost grid boxes go; then puts them there until a
  /// share, 0 to 1, is there, as often as that is not 1; then, as often as is_built() says no, makes as many
  /// cells as have so many boxes or a little more, and returns how many they have. In the meantime nothing
  /// else is to be called but allow().
  void begin_build(const Boxes& boxes);
  /// Before that: the memory that another tree was built with, and found() is in, which only has changes from
  /// now on.
  [[gnu::cold]] void take_working_memory(CellTree& other);
  void fill_cells(const Boxes& boxes, double share);
  std::uint64_t go_on(std::uint64_t boxes);
  bool is_built() const { return cells_built_ == root_.grid.cells(); }

  /// Changes and questions of an update follow. When they turn out to take more memory or comparisons than
  /// to make the tree anew, they throw TooMuchWork; after a change that did, only clear() or build() may
  /// follow.
  void begin_changes();

  /// Moves, adds and takes out bodies, each once, and finds all pairs that these now have: touched().
  void change(std::span<const FatBoxChange> changes);

  /// The same, and found() are the pairs that there are then: those of slots whose entry in `changed`, by
  /// slot, is not 0, which are the ones of the changes, are now touched().
  [[gnu::cold]] void change_found(std::span<const FatBoxChange> changes, const std::uint8_t* changed);

  /// Changes one body, in time that does not depend on how many cells there are, and finds no pairs.
  void change_one(const FatBoxChange& change);

  /// Appends the slots of all bodies whose boxes overlap this one, each once.
  void find_partners(const Aabb& box, Keys& slots);

  /// Valid until the next build() or change_found().
  KeyParts found() const { return found_; }
  /// Valid until the next change().
  KeyParts touched() const { return touched_; }

  const Node& root() const { return root_; }
  /// Cells of the topmost grid.
  std::uint64_t pieces() const { return root_.grid.cells(); }
  /// Cells wear out: boxes that enter leave gaps in memory behind and crowd cells.
  bool is_worn_out() const { return copies() > 2 * built_copies_ + 1024; }
  /// Boxes put into cells by the last build and since.
  std::uint64_t copies() const;
  /// Comparisons of two boxes so far.
  std::uint64_t tests() const;
  /// Bytes held.
  [[gnu::cold]] std::size_t bytes() const;

 private:
  void reset(std::size_t boxes);
  TreeBuilder builder();
  void list_found();

  Crew& crew_;
  const Kernels& kernels_;
  PieceFinder* finder_;
  std::span<const BodyFilter> filters_;
  std::vector<std::unique_ptr<Scratch>> scratches_;
  std::vector<std::span<const std::uint64_t>> found_;  // by worker
  std::vector<std::span<const std::uint64_t>> touched_;
  Node root_;
  Placement placement_;            // while the tree is built
  double filled_ = 0;              // the share of it that is in cells
  std::uint32_t cells_built_ = 0;  // of the topmost grid
  std::size_t built_boxes_ = 0;
  std::uint64_t built_copies_ = 0;
};

}  // namespace cellsweep::stream
