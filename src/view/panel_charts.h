/// @file
/// The panel's drawings: how long frames took, and what local stores hold.
#pragma once

#include <vector>

#include "cellsweep/local_store.h"

namespace cellsweep::view {

/// A bar for each frame, the newest at the right, in orange those too long for the picture; below it the
/// median and the longest. Times in milliseconds.
void draw_frame_times(const std::vector<float>& times);

/// A strip for each SPE, a region a colour, and what the colours are.
void draw_local_stores(const LocalStoreMap& map);

}  // namespace cellsweep::view
