/// @file
/// Whether boxes can be taken as they are: asked of every box that comes in.
#pragma once

#include <span>

#include "cellsweep/aabb.h"

namespace cellsweep {

/// True when every box is valid and canonical as it is.
bool are_clean(std::span<const Aabb> boxes);

/// True when every box is valid once it is canonical. Few callers have any that are not clean.
[[gnu::cold]] bool are_valid(std::span<const Aabb> boxes);

}  // namespace cellsweep
