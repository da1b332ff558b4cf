/// @file
/// The engine table with all engines that this build has.
#pragma once

#include <span>

#include "cellsweep/engines.h"
#ifdef CELLSWEEP_HAS_CELL
#include "cellsweep/cell.h"
#endif
#ifdef CELLSWEEP_HAS_EMBREE
#include "cellsweep/embree.h"
#endif

namespace cellsweep {

inline bool add_every_engine() {
#ifdef CELLSWEEP_HAS_CELL
  add_cell_engines();
#endif
#ifdef CELLSWEEP_HAS_EMBREE
  add_embree_engine();
#endif
  return true;
}

/// engine_table() after those of the other libraries were added, once.
inline std::span<const EngineInfo> every_engine() {
  [[maybe_unused]] static const bool added = add_every_engine();
  return engine_table();
}

}  // namespace cellsweep
