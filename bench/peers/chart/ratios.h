/// @file
/// How far `stream` is ahead of the best of the others, cell by cell.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/measured/measured_rows.h"
#include "bench/peers/chart/results.h"

namespace cellsweep::bench {

/// Whether a row is none of ours: neither an engine of the project nor the limit of memory.
bool is_other(std::string_view peer);

/// One cell in which `stream` and at least one other were measured.
struct CellRatio {
  CellKey cell;
  double pairs = 0;
  PeerTime stream;
  std::string best;  ///< the fastest of the exact others
  PeerTime best_time;
  double memory = 0;  ///< seconds of the limit that memory sets; 0 when that was not measured

  double ratio() const { return ratio_in_turns(best_time.turns, stream.turns); }
  double over_memory() const { return memory > 0 ? stream.seconds / memory : 0; }
};

/// In the order of scene, bodies, mode. A peer that was not exact in a cell is no candidate there.
std::vector<CellRatio> ratios_of(const PeerResults& results);

/// The geometric mean of the ratios, and the cell with the smallest; nothing for an empty list.
struct RatioSummary {
  double mean = 0;
  CellRatio smallest;
};
std::optional<RatioSummary> summarise(const std::vector<CellRatio>& ratios);

}  // namespace cellsweep::bench
