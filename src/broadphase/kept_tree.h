/// @file
/// The tree that queries keep with a Broadphase from when it pays, and what has changed since it was right.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/list.h"
#include "broadphase/tree_account.h"
#include "cellsweep/engine/slots.h"

namespace cellsweep {

struct BodyChanges;

namespace queries {
class BoxTree;
}  // namespace queries

/// Who pays the price of a tree makes it; and when bodies have changed, then who pays the price of bringing
/// it up to date does that. Nobody needs to wait: others go on without. From any number of threads, but for
/// note() and drop().
class KeptTree {
 public:
  KeptTree() = default;
  KeptTree(const KeptTree&) = delete;
  KeptTree& operator=(const KeptTree&) = delete;
  ~KeptTree() { drop(); }

  /// As of the last update; null: there is none, or not yet.
  const queries::BoxTree* get() const { return current_.load(std::memory_order_acquire); }
  TreeAccount& account() { return account_; }

  /// Whether the caller is to bring the tree up to date or to make one, and then call keep() or give_up():
  /// one at a time.
  bool begin() { return !is_being_made_.test_and_set(std::memory_order_acquire); }

  /// The tree that is not up to date, for who has begun; null: there is none. The slots whose bodies came,
  /// went or moved since, some twice; or all may have.
  queries::BoxTree* outdated() { return tree_; }
  std::span<const Slot> changed() const { return changed_.view(); }
  bool all_may_have_changed() const { return all_may_have_changed_; }

  /// It is up to date, whether it is the outdated one, or another one, which is given to be kept, and holds
  /// so many bytes. When std::bad_alloc is thrown it was not kept.
  void keep(std::size_t bytes);
  void keep(queries::BoxTree* tree, void (*destroy)(const queries::BoxTree*), std::size_t bodies,
            std::size_t bytes);
  /// There is no tree any more.
  void give_up();

  /// An update. While nobody asks.
  void note(const BodyChanges& changes);
  /// As give_up(), while nobody asks.
  void drop();
  /// Held, while nobody asks.
  std::size_t bytes() const { return tree_bytes_ + changed_.bytes(); }

 private:
  void destroy_tree();
  void note_for_tree(const BodyChanges& changes);
  void show_tree(std::size_t bytes);

  std::atomic<const queries::BoxTree*> current_ = nullptr;  // null or tree_
  std::atomic_flag is_being_made_;
  queries::BoxTree* tree_ = nullptr;
  void (*destroy_)(const queries::BoxTree*) = nullptr;
  std::size_t tree_bytes_ = 0;
  List<Slot> changed_;  // has room for room_
  std::size_t room_ = 0;
  bool all_may_have_changed_ = false;
  unsigned unasked_ = 0;  // updates since the tree was right
  TreeAccount account_;
};

}  // namespace cellsweep
