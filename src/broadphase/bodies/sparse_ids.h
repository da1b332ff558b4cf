/// @file
/// Slots of ids that lie far apart.
#pragma once

#include <cstdint>

#include "base/memory/memory.h"
#include "base/sparse_table.h"
#include "cellsweep/pair.h"

namespace cellsweep {

/// A number that nobody foretells, another one each time. From any thread.
std::uint64_t unforeseen_key();

using SparseIds = SparseTable<BodyId, Vector, unforeseen_key>;

}  // namespace cellsweep
