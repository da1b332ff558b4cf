/// @file
/// The results of the suite of peers as tables in Markdown and CSV.
#pragma once

#include <string>

#include "bench/peers/chart/results.h"

namespace cellsweep::bench {

/// A row for each number of bodies, a column for each mode: geometric mean over the scenes of best peer over
/// `stream`, and the smallest of them with its scene and peer. Behind it one line with the mean of all cells,
/// and one for each peer that was not exact.
std::string summary_markdown(const PeerResults& results);

/// The sentence that the summary comes down to, in two lines; empty when nothing can be compared.
std::string headline_markdown(const PeerResults& results);

/// A row for each cell: `stream`, the best of the others, mean and 99th percentile of both, their ratio,
/// `stream` over the limit of memory.
std::string cells_markdown(const PeerResults& results);

/// The evenness of `stream`'s frames; empty when that was not measured.
std::string tails_markdown(const PeerResults& results);

/// Every time of every peer, a row for each: scene, bodies, mode, peer, seconds, mean, p99, spread,
/// pairs, missing, extra, over stream.
std::string times_csv(const PeerResults& results);

}  // namespace cellsweep::bench
