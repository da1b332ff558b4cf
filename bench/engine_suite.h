/// @file
/// The suite of all engines: engine x scene x number of bodies x mode.
#pragma once

namespace cellsweep::bench {

/// Registers a row `engine/NAME/SCENE/N/MODE` for every combination that the engine's capacity allows. A row
/// is compared with the oracle before it is timed and skipped with an error when they differ. The time is
/// that of handing over the boxes that changed and of update(), without phases marked as set-up. Counters:
/// `pairs`, and `boxes/s`, all bodies of the scene over the time of one frame; the label is the pairs' hash.
void register_engine_suite();

}  // namespace cellsweep::bench
