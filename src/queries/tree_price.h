/// @file
/// When a tree of boxes pays.
#pragma once

#include <cstdint>

#include "queries/world.h"

namespace cellsweep::queries {

/// What a question cost that was answered without a tree: boxes and cells looked at. Once all questions have
/// looked at so many that a tree could have been made for it, or brought up to date after an update, that is
/// done by this call (TreeAccount): so all of them together take at most about twice the time of the better
/// way. Without memory for it questions go on as before.
void pay_for_tree(const World& world, std::uint64_t looks);

/// Makes the tree now, or brings it up to date. std::bad_alloc may leave it.
void make_tree(const World& world);

}  // namespace cellsweep::queries
