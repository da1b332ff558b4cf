#include "queries/tree_price.h"

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

/// What KeptTree::begin() allowed; given up unless there is a tree in the end.
class Making {
 public:
  explicit Making(const World& world) : kept_(world.kept_tree()), bodies_(world.bodies()) {}
  Making(const Making&) = delete;
  Making& operator=(const Making&) = delete;
  ~Making() {
    if (!is_done_) kept_.give_up();
  }

  /// Whether there was a tree that is up to date now, and worth keeping.
  bool update() {
    BoxTree* const tree = kept_.outdated();
    if (tree == nullptr || !update(*tree)) return false;
    const bool is_worn =
        tree->wear() > (kept_.account().has_paid_off() ? tuning::kWornTree : tuning::kWornOutTree);
    is_worn ? kept_.account().wears_out() : kept_.keep(tree->bytes());
    is_done_ = !is_worn;
    return is_done_;
  }
  void make() {
    auto tree = std::make_unique<BoxTree>(bodies_);
    kept_.keep(tree.get(), destroy, bodies_.boxes.size(), tree->bytes());
    static_cast<void>(tree.release());
    is_done_ = true;
  }

 private:
  bool update(BoxTree& tree) {
    return kept_.all_may_have_changed() ? tree.update(bodies_) : tree.update(bodies_, kept_.changed());
  }

  KeptTree& kept_;
  BodyBoxes bodies_;
  bool is_done_ = false;
};

}  // namespace

void pay_for_tree(const World& world, std::uint64_t looks) {
  if (looks <= tuning::kLooksInTree) return;
  KeptTree& kept = world.kept_tree();
  if (!kept.account().pay(looks - tuning::kLooksInTree) || !kept.begin()) return;
  try {
    const bool makes = kept.outdated() == nullptr || kept.account().has_paid_off();
    Making making(world);
    if (!making.update() && makes) making.make();
  } catch (const std::bad_alloc&) {
  }
}

void make_tree(const World& world) {
  while (world.tree() == nullptr) {
    if (world.kept_tree().begin()) {
      Making making(world);
      if (!making.update()) making.make();
      return;
    }
    std::this_thread::yield();
  }
}

}  // namespace cellsweep::queries
