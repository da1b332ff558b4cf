/// @file
/// The suite of all engines: engine x scene x number of bodies x mode.
#pragma once

namespace cellsweep::bench {

/// Registers a row `engine/NAME/SCENE/N/MODE` for every combination that the engine's capacity allows, of the
/// oracle up to 20,000 bodies, with default options.
void register_engine_suite();

}  // namespace cellsweep::bench
