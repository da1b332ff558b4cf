#include "broadphase/kept_tree.h"

namespace cellsweep {

[[gnu::cold, gnu::noinline]] void KeptTree::drop() {
  if (const queries::BoxTree* const tree = get()) destroy_(tree);
  tree_.store(nullptr, std::memory_order_relaxed);
  give_up();
}

}  // namespace cellsweep
