/// @file
/// The world that queries look at: bodies by slot as of the last update, and which of them are answers.
#pragma once

#include <cstddef>
#include <span>

#include "broadphase/last_update.h"
#include "cellsweep/query.h"
#include "queries/kernels/kernel.h"
#include "queries/tree/box_tree.h"

namespace cellsweep::queries {

/// A body that may be an answer.
struct Candidate {
  Slot slot;
  Aabb box;
};

class World {
 public:
  explicit World(const LastUpdate& last)
      : boxes_(last.bodies.all_boxes()),
        states_(last.bodies.staged().states()),
        ids_(last.bodies.table().ids()),
        filters_(last.bodies.filters().view()),
        root_(last.cells.root),
        are_exact_(root_ == nullptr || last.cells.are_exact),
        kept_tree_(last.tree),
        kernels_(query_kernels(last.cells.isa)) {}

  /// By slot, NaN where nobody is.
  std::span<const Aabb> boxes() const { return boxes_; }
  const Aabb& box(Slot slot) const { return boxes_[slot]; }
  /// Of one who has a box: whether the last update saw it.
  bool is_seen(Slot slot) const { return states_[slot] != kInserted; }
  BodyId id(Slot slot) const { return ids_[slot]; }
  BodyFilter filter(Slot slot) const { return filter_of(filters_, slot); }

  BodyBoxes bodies() const { return {boxes_, states_}; }

  /// The cells, which hold those whom the last update saw; null: there are none.
  const stream::Node* root() const { return root_; }
  /// Whether a box that walk_region() finds overlaps for certain.
  bool overlaps_are_certain() const { return are_exact_; }
  const QueryKernels& kernels() const { return kernels_; }

  /// A tree of the same bodies; null: there is none, or not yet.
  const BoxTree* tree() const { return kept_tree_.get(); }
  KeptTree& kept_tree() const { return kept_tree_; }

  /// Whether a filter lets a body be an answer: but for the predicate, and all of it.
  bool may_be_answer(const QueryFilter& question, Slot slot) const {
    return !question.as || may_pair(*question.as, filter(slot));
  }
  bool is_answer(const QueryFilter& question, Slot slot) const {
    return may_be_answer(question, slot) && (!question.predicate || question.predicate(id(slot)));
  }

 private:
  std::span<const Aabb> boxes_;
  const BodyState* states_;
  const BodyId* ids_;
  std::span<const BodyFilter> filters_;
  const stream::Node* root_;
  bool are_exact_;
  KeptTree& kept_tree_;
  const QueryKernels& kernels_;
};

}  // namespace cellsweep::queries
