/// @file
/// When a tree of boxes pays.
#pragma once

#include <cstdint>

#include "queries/world.h"

namespace cellsweep::queries {

/// What a question cost that was answered without a tree: boxes and cells looked at. Once all questions since
/// the bodies changed have looked at so many more than a tree would have that one could have been made for
/// it, it is made, by this call: so all of them together take at most about twice the time of the better way.
/// Without memory for it questions go on as before.
void pay_for_tree(const World& world, std::uint64_t looks);

/// Makes the tree now, unless there is one. std::bad_alloc may leave it.
void make_tree(const World& world);

}  // namespace cellsweep::queries
