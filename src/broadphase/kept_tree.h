/// @file
/// The tree that queries keep with a Broadphase from when it pays until its bodies change.
#pragma once

#include <atomic>
#include <cstdint>

namespace cellsweep {

namespace queries {
class BoxTree;
}  // namespace queries

/// Looking at boxes one by one is what a query pays; who pays the price of a tree makes it. Nobody needs to
/// wait: others go on without. From any number of threads, but for drop().
class KeptTree {
 public:
  KeptTree() = default;
  KeptTree(const KeptTree&) = delete;
  KeptTree& operator=(const KeptTree&) = delete;
  ~KeptTree() { drop(); }

  /// Null: there is none yet.
  const queries::BoxTree* get() const { return tree_.load(std::memory_order_acquire); }

  /// Whether the price is paid now.
  bool pay(std::uint64_t looks, std::uint64_t price) {
    return paid_.fetch_add(looks, std::memory_order_relaxed) + looks >= price;
  }

  /// Whether the caller is to make the tree, and then call keep() or give_up(): one at a time.
  bool begin() { return !is_being_made_.test_and_set(std::memory_order_acquire); }
  void keep(const queries::BoxTree* tree, void (*destroy)(const queries::BoxTree*)) {
    destroy_ = destroy;
    tree_.store(tree, std::memory_order_release);
  }
  void give_up() {
    paid_.store(0, std::memory_order_relaxed);
    is_being_made_.clear(std::memory_order_release);
  }

  /// While nobody asks: what was paid is forgotten, too.
  void drop();

 private:
  std::atomic<const queries::BoxTree*> tree_ = nullptr;
  std::atomic<std::uint64_t> paid_ = 0;
  std::atomic_flag is_being_made_;
  void (*destroy_)(const queries::BoxTree*) = nullptr;
};

}  // namespace cellsweep
