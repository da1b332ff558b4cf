/// @file
/// Whether an id is listed twice.
#pragma once

#include <span>

#include "base/threads/crew.h"
#include "cellsweep/pair.h"

namespace cellsweep {

/// True when each of these ids, any numbers, is there once. It takes a few bytes an id and no table of them:
/// ids are compared only where their hashes have a bit in common. Linear in their number whatever they are.
/// By all workers. Throws std::bad_alloc.
bool are_distinct(Crew& crew, std::span<const BodyId> ids);

}  // namespace cellsweep
