/// @file
/// The rows of the engine table that this library brings.
#pragma once

#include <vector>

#include "cellsweep/engines.h"

namespace cellsweep {

/// `control`, `stream`, `oracle`.
std::vector<EngineInfo> core_engines();

}  // namespace cellsweep
