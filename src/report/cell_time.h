/// @file
/// Frames on a Cell's clock: which of a run are shown, and what the host's side is taken to cost.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "report/run_engine.h"

namespace cellsweep::report {

/// Stated costs of what is not simulated, always shown apart from the SPEs' time.
struct PpuCosts {
  /// A Cell's PPE against this machine on the host's part: an in-order core at 3.2 GHz with 512 KB of second
  /// level cache, on code that follows pointers. Assumed, not measured.
  double factor = 5;
  /// Starting the SPE threads of a frame, in microseconds: the document's floor of a static frame.
  double spu_start_us = 3000;
};

/// A frame that stands for its kind.
struct CellRow {
  std::string_view kind;   ///< initial, static or dynamic
  std::string_view which;  ///< empty, median or longest
  const CellFrame* frame;
};

/// Frame 0, then of the frames in which nothing moved, and of those in which something did, the median and
/// the longest, by the SPE that took longest. Refers to the run's memory.
std::vector<CellRow> cell_rows(const RunReport& run);

/// For each run that was counted: a row an SPE, and below them a row a frame with the host's side.
std::string cell_tables(std::span<const RunReport> runs, const PpuCosts& costs);

/// {"ppu_factor","frames":[{"kind","which","frame","spes":[{"sort_us","change_detection_us","compaction_us",
/// "overlap_us","dma_wait_us","other_us","total_us"}],"spu_us","spu_start_us","host_cpu_ms","ppu_us"}]}
nlohmann::ordered_json cell_json(const RunReport& run, const PpuCosts& costs);

}  // namespace cellsweep::report
