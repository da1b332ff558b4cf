#include "queries/paths/path_walk.h"

#include <bit>

#include "queries/paths/path_in_cells.h"
#include "queries/paths/path_taker.h"
#include "queries/rows.h"
#include "queries/tree/box_tree.h"
#include "queries/tree_price.h"

namespace cellsweep::queries {
namespace {

bool give_bodies(void* taker, const TreeNode& node, std::uint32_t bodies) {
  auto& to = *static_cast<PathTaker*>(taker);
  std::uint32_t count = 0;
  for (; bodies != 0; bodies &= bodies - 1)
    to.put(count++, candidate_of(node, static_cast<std::size_t>(std::countr_zero(bodies))));
  return to.give(count);
}

using WalkTree = decltype(TreeKernels::cast);

void walk(const World& world, const Path& path, PathTaker& taker, WalkTree walk_tree) {
  if (const BoxTree* const tree = world.tree())
    return walk_tree(tree->nodes(), taker.numbers(), {give_bodies, &taker});
  pay_for_tree(world,
               world.root() != nullptr ? walk_cells(world, Cast(path), taker) : scan_boxes(world, taker));
}

}  // namespace

void walk_path(const World& world, const Path& path, Take take) {
  PathTaker taker(path, take);
  walk(world, path, taker, world.kernels().trees->cast);
}

void walk_whole_path(const World& world, const Path& path, Take take) {
  PathTaker taker(path, take);
  walk(world, path, taker, world.kernels().trees->cast_all);
}

bool walk_to_any(const World& world, const Path& path, Take take) {
  PathTaker taker(path, take);
  if (const BoxTree* const tree = world.tree(); tree != nullptr && taker.numbers().can_be_certain)
    return world.kernels().any(tree->nodes(), taker.numbers(), {give_bodies, &taker});
  walk(world, path, taker, world.kernels().trees->cast_all);
  return false;
}

}  // namespace cellsweep::queries
