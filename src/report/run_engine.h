/// @file
/// Runs an engine over frames, takes the time of its own work, and keeps pair counts and hashes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "cellsweep/cell.h"
#include "cellsweep/world/frame_source.h"
#include "report/hand_over.h"

namespace cellsweep::report {

struct RunSettings {
  std::size_t updates = 0;                 ///< frames after frame 0; fewer when the source ends before
  std::vector<std::size_t> report_frames;  ///< frames whose pairs are counted; empty: the first and the last
  Shape shape = Shape::boxes;              ///< what the engine is given
};

/// The pairs of one frame.
struct FrameReport {
  std::size_t frame = 0;
  std::size_t pairs = 0;
  std::uint64_t hash = 0;
};

/// A frame on a Cell's clock.
struct CellFrame {
  std::size_t frame = 0;
  std::size_t moved = 0;         ///< bodies that were handed over, or taken back
  std::vector<SpeTime> spes;     ///< one an SPE
  double host_cpu_ms = 0;        ///< CPU time of the host's part, as measured on this machine
  bool threads_started = false;  ///< the frame started the SPE threads

  /// Microseconds of the SPE that took longest.
  double longest_us() const;
};

/// What a run took and found. Times are those of handing bodies over and of update(), less the phases that
/// the engine marks as set-up, which stand apart in `setup_ms`.
struct RunReport {
  std::string engine;
  std::size_t bodies = 0;  ///< at frame 0
  double initial_ms = 0;
  double setup_ms = 0;
  std::vector<double> update_ms;  ///< one an update after frame 0
  std::vector<FrameReport> frames;
  std::vector<CellFrame> cell;  ///< every frame, when the engine counts it (SpeOptions::cycles)
};

/// Runs an empty engine over the frames of a source that stands at frame 0; an interrupted run ends after the
/// frame it is at. Errors: those of the engine, and bad_input for a report frame beyond the source's last.
Result<RunReport> run_engine(Broadphase& engine, FrameSource& source, const RunSettings& settings);

}  // namespace cellsweep::report
