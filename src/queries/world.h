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

/// Reads what it is asked for when it is asked: most questions need a part of it, and are short.
class World {
 public:
  explicit World(const LastUpdate& last) : last_(last), kernels_(query_kernels(last.cells.isa)) {}

  /// By slot, NaN where nobody is.
  std::span<const Aabb> boxes() const { return last_.bodies.all_boxes(); }
  const Aabb& box(Slot slot) const { return boxes()[slot]; }
  /// Of one who has a box: whether the last update saw it.
  bool is_seen(Slot slot) const { return last_.bodies.staged().state(slot) != kInserted; }
  BodyId id(Slot slot) const { return last_.bodies.table().id(slot); }
  BodyFilter filter(Slot slot) const { return last_.bodies.filter(slot); }

  BodyBoxes bodies() const { return {boxes(), last_.bodies.staged().states()}; }

  /// The cells, which hold those whom the last update saw; null: there are none.
  const stream::Node* root() const { return last_.cells.root; }
  /// Whether a box that walk_region() finds overlaps for certain.
  bool overlaps_are_certain() const { return root() == nullptr || last_.cells.are_exact; }
  const QueryKernels& kernels() const { return kernels_; }

  /// A tree of the same bodies; null: there is none, or not yet.
  const BoxTree* tree() const { return kept_tree().get(); }
  KeptTree& kept_tree() const { return last_.tree; }

  /// Whether a filter lets a body be an answer: but for the predicate, and all of it.
  bool may_be_answer(const QueryFilter& question, Slot slot) const {
    return !question.as || may_pair(*question.as, filter(slot));
  }
  bool is_answer(const QueryFilter& question, Slot slot) const {
    return may_be_answer(question, slot) && (!question.predicate || question.predicate(id(slot)));
  }

 private:
  const LastUpdate& last_;
  const QueryKernels& kernels_;
};

}  // namespace cellsweep::queries
