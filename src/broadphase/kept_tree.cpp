#include "broadphase/kept_tree.h"

#include "base/tuning.h"
#include "cellsweep/engine/engine.h"

namespace cellsweep {
namespace {

std::size_t count_of(const BodyChanges& changes) {
  return changes.removed.size() + changes.moved.size() + changes.inserted.size();
}

}  // namespace

[[gnu::cold]] void KeptTree::keep(std::size_t bytes) {
  account_.brought_up_to_date();
  show_tree(bytes);
}

[[gnu::cold]] void KeptTree::keep(queries::BoxTree* tree, void (*destroy)(const queries::BoxTree*),
                                  std::size_t bodies, std::size_t bytes) {
  const std::size_t room = TreeAccount::few_of(bodies);
  changed_.reserve(room);
  room_ = room;
  destroy_tree();
  tree_ = tree;
  destroy_ = destroy;
  account_.made();
  show_tree(bytes);
}

[[gnu::cold]] void KeptTree::show_tree(std::size_t bytes) {
  tree_bytes_ = bytes;
  changed_.clear();
  all_may_have_changed_ = false;
  unasked_ = 0;
  current_.store(tree_, std::memory_order_release);
}

[[gnu::cold]] void KeptTree::give_up() {
  destroy_tree();
  account_.lost();
  is_being_made_.clear(std::memory_order_release);
}

[[gnu::cold]] void KeptTree::destroy_tree() {
  if (tree_ == nullptr) return;
  destroy_(tree_);
  tree_ = nullptr;
  tree_bytes_ = 0;
}

void KeptTree::note(const BodyChanges& changes) {
  account_.begin_update(count_of(changes), changes.boxes.size(), get() != nullptr);
  if (tree_ != nullptr) note_for_tree(changes);
}

[[gnu::cold, gnu::noinline]] void KeptTree::note_for_tree(const BodyChanges& changes) {
  if (++unasked_ > tuning::kMostUnasked) return drop();
  const std::size_t bodies = changes.boxes.size();
  all_may_have_changed_ = all_may_have_changed_ || changed_.size() + count_of(changes) > room_;
  if (!all_may_have_changed_) {
    for (const std::span<const Slot> slots : {changes.removed, changes.moved, changes.inserted}) {
      for (const Slot slot : slots) changed_.push(slot);
    }
  }
  account_.expect_changes(all_may_have_changed_ ? bodies : changed_.size(), bodies, get() != nullptr);
  current_.store(nullptr, std::memory_order_relaxed);
  is_being_made_.clear(std::memory_order_relaxed);
}

[[gnu::cold, gnu::noinline]] void KeptTree::drop() {
  current_.store(nullptr, std::memory_order_relaxed);
  changed_ = List<Slot>();
  room_ = 0;
  give_up();
}

}  // namespace cellsweep
