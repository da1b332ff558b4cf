#include "queries/tree/tree_price.h"

#include <memory>
#include <new>
#include <thread>

#include "base/tuning.h"
#include "queries/tree/box_tree.h"

namespace cellsweep::queries {
namespace {

void destroy(const BoxTree* tree) {
  delete tree;
}

/// What KeptTree::begin() allowed; given up unless it is kept.
class Making {
 public:
  explicit Making(KeptTree& kept) : kept_(kept) {}
  Making(const Making&) = delete;
  Making& operator=(const Making&) = delete;
  ~Making() {
    if (!is_kept_) kept_.give_up();
  }

  void keep(std::unique_ptr<const BoxTree> tree) {
    kept_.keep(tree.release(), destroy);
    is_kept_ = true;
  }

 private:
  KeptTree& kept_;
  bool is_kept_ = false;
};

void make_and_keep(const World& world) {
  Making making(world.kept_tree());
  const auto is_there = [&](Slot slot) {
    const Aabb& box = world.box(slot);
    return box.min[0] <= box.max[0] && world.is_seen(slot);
  };
  making.keep(std::make_unique<const BoxTree>(world.boxes(), is_there));
}

}  // namespace

void pay_for_tree(const World& world, std::uint64_t looks) {
  if (looks <= tuning::kLooksInTree) return;
  const std::uint64_t price = tuning::kTreePrice * (world.boxes().size() + tuning::kFewestPaidFor);
  if (!world.kept_tree().pay(looks - tuning::kLooksInTree, price) || !world.kept_tree().begin()) return;
  try {
    make_and_keep(world);
  } catch (const std::bad_alloc&) {
  }
}

void make_tree(const World& world) {
  while (world.tree() == nullptr) {
    if (world.kept_tree().begin()) return make_and_keep(world);
    std::this_thread::yield();
  }
}

}  // namespace cellsweep::queries
