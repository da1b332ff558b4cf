/// @file
/// Local-store layouts of the Cell engines: whether bodies fit, and how many do (C14).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cellsweep/broadphase.h"
#include "cellsweep/local_store.h"
#include "engines/cell/emulation.h"

namespace cellsweep::cell {

/// The buffers that an engine's program allocates for so many bodies, each as large as _malloc_align makes
/// it.
using BufferList = std::function<std::vector<LocalStorePart>(std::uint64_t bodies)>;

/// Code, data and stack of the budget, then the buffers.
LocalStoreMap make_local_store_map(std::string engine, const LocalStoreBudget& budget,
                                   const BufferList& buffers, std::uint64_t bodies);

/// The most bodies, up to `most`, whose map fits; 0 when none do. Maps must grow with the bodies.
std::uint64_t bodies_that_fit_local_store(const LocalStoreBudget& budget, const BufferList& buffers,
                                          std::uint64_t most);

/// The map in one line: every part with its bytes, the limit, and what is free or missing.
std::string describe(const LocalStoreMap& map);

/// Capacity of an engine limited by its local store and, as a last resort, by `most`, which `why_most`
/// explains as a phrase. The reason names the parts of the map of the first body too many. Errors: capacity,
/// when not even one body fits.
Result<Capacity> local_store_capacity(std::string engine, const LocalStoreBudget& budget,
                                      const BufferList& buffers, std::uint64_t most, std::string why_most);

}  // namespace cellsweep::cell
