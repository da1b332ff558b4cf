/// @file
/// Engine `embree`, of the library cellsweep::embree.
#pragma once

#include <string>

#include "cellsweep/broadphase.h"
#include "cellsweep/export.h"

namespace cellsweep {

/// For comparison: Embree's tree over all boxes, built anew when something changed and run against itself
/// (rtcCollide), what it finds tested again.
struct EmbreeOptions {
  unsigned threads = 0;  ///< of Embree's own; 0: one for each core
  std::string trace{};   ///< as StreamOptions::trace
};

/// Errors: bad_option for a trace file that cannot be written.
CELLSWEEP_API Result<Broadphase> make_broadphase(const EmbreeOptions& options);

/// Adds `embree` to engine_table().
CELLSWEEP_API void add_embree_engine();

}  // namespace cellsweep
