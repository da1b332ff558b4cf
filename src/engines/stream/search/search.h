/// @file
/// Finds all that overlap among the boxes of engine `stream`: by a sweep, where there are few, or by cells,
/// which can be changed then.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "base/sorting/pair_sort.h"
#include "base/threads/crew.h"
#include "cellsweep/engine/piece_finder.h"
#include "engines/stream/bodies/fat_boxes.h"
#include "engines/stream/cells/cell_tree.h"
#include "engines/stream/search/sweep.h"

namespace cellsweep::stream {

class Search {
 public:
  static constexpr std::size_t kAnyNumber = ~std::size_t{0};

  /// `finder` finds pairs in the kernels' place; null for them. More pairs than `max_pairs` are refused.
  Search(Crew& crew, const Kernels& kernels, PieceFinder* finder, std::size_t max_pairs);

  /// From now on pairs must be allowed by these filters: CellTree::allow().
  void allow(std::span<const BodyFilter> filters) {
    cells_->allow(filters);
    if (prepared_) prepared_->allow(filters);
    swept_.allow(filters);
  }

  /// From now on fat boxes have far too many pairs when they have more than this.
  void limit_candidates(std::size_t most) { most_candidates_ = most; }

  /// Finds all pairs of fat boxes anew: found(). So many slots and fewer are swept; makes cells for
  /// others, and where a sweep would take more. Where fat boxes have far too many pairs, they become the
  /// boxes themselves again. Throws TooManyPairs when boxes have more than allowed.
  void find_all(FatBoxes& fat_boxes, std::span<const Aabb> boxes, std::size_t most_swept);

  /// Whether the last find_all() made cells. They follow the bodies by change() and CellTree::change_one().
  bool has_cells() const { return has_cells_; }
  CellTree& cells() { return *cells_; }
  const CellTree& cells() const { return *cells_; }

  /// Changes the cells. False when everything is to be found anew: that would take less, or so many
  /// candidates began as is no reason to refuse, for all of them may have become too large.
  bool change(std::span<const FatBoxChange> changes);

  /// The cells have seen so many changes that they should be made anew.
  bool is_worn_out() const { return cells_->is_worn_out(); }

  /// Cells for later: after begin_prepared(), prepared() goes on as CellTree::begin_build() says, and
  /// use_prepared() puts them in the place of those that there are. Throws TooManyPairs.
  [[gnu::cold]] void begin_prepared(const Boxes& boxes);
  CellTree& prepared() { return *prepared_; }
  void use_prepared();
  /// Forgets them, and their memory.
  [[gnu::cold]] void drop_prepared();

  /// Nobody is left.
  [[gnu::cold]] void clear();
  /// The cells stay; memory for work, what was found and prepared goes back.
  [[gnu::cold]] void give_back();

  /// Valid until the next call.
  KeyParts found() const { return has_cells_ ? cells_->found() : KeyParts{&swept_view_, 1}; }
  /// Comparisons of two boxes so far.
  [[gnu::noinline]] std::uint64_t tests() const {
    return cells_->tests() + prepared_tests() + sweep_.tests();
  }
  std::size_t bytes() const {
    return cells_->bytes() + (prepared_ ? prepared_->bytes() : 0) + sweep_.bytes() + swept_.bytes();
  }

 private:
  std::size_t generous_limit() const;
  void find_among(std::span<const Aabb> boxes, std::size_t most, std::size_t most_swept);
  bool sweep(std::span<const Aabb> boxes, std::size_t most);
  std::uint64_t prepared_tests() const { return prepared_ ? prepared_->tests() : 0; }

  Crew& crew_;
  const Kernels& kernels_;
  PieceFinder* finder_;
  std::size_t max_pairs_;
  std::size_t most_candidates_ = kAnyNumber;
  std::unique_ptr<CellTree> cells_;
  std::unique_ptr<CellTree> prepared_;  // once cells are prepared
  bool has_cells_ = false;
  Sweep sweep_;
  Keys swept_;
  std::span<const std::uint64_t> swept_view_;
};

}  // namespace cellsweep::stream
