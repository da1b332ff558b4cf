/// @file
/// The chart of the suite of peers, as a script for gnuplot.
#pragma once

#include <string>

#include "bench/peers/chart/results.h"

namespace cellsweep::bench {

/// A script that draws a PNG on standard output: for one scene (a place in kPeerScenes) the median time of a
/// frame over the number of bodies, both logarithmic, a panel for each mode, a line for each peer, and the
/// key in a panel of its own. Rows that were not exact are left out.
std::string chart_script(const PeerResults& results, std::size_t scene);

}  // namespace cellsweep::bench
