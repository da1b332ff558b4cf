/// @file
/// What queries read of a Broadphase: everything as of its last update.
#pragma once

#include <atomic>

#include "base/threads/crew.h"
#include "broadphase/bodies/bodies.h"
#include "broadphase/kept_tree.h"
#include "broadphase/readers.h"
#include "cellsweep/engine/engine.h"

namespace cellsweep {

struct LastUpdate {
  const Bodies& bodies;  ///< those that the update did not see, which have boxes already, among them
  CellsToQuery cells;    ///< none after an update that failed
  KeptTree& tree;
  Readers& readers;
  Crew& crew;                       ///< belongs to whoever
  std::atomic_flag& crew_is_taken;  ///< has set this
};

}  // namespace cellsweep
