/// @file
/// The results of the suite of peers in the project's own pages.
#pragma once

#include <filesystem>

#include "bench/peers/chart/results.h"
#include "cellsweep/status.h"

namespace cellsweep::bench {

/// Of the project in a folder: the summary in docs/peers.md and its sentence in README.md, each between its
/// marks, and the chart, a PNG file, as bench/figures/peers.png. Errors: bad_input for a file that cannot be
/// read or written, and for a page without marks; then no page has changed.
Status update_pages(const std::filesystem::path& project, const PeerResults& results,
                    const std::filesystem::path& chart);

}  // namespace cellsweep::bench
