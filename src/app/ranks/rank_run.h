/// @file
/// Runs the frames of a source in a world over ranks, measures what each rank did, and keeps pair counts and
/// hashes of all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "cellsweep/ranks.h"
#include "cellsweep/world/frame_source.h"

namespace cellsweep::app {

struct RankRunSettings {
  std::size_t updates = 0;                 ///< frames after frame 0; fewer when the source ends before
  std::vector<std::size_t> report_frames;  ///< frames whose pairs are counted; empty: the first and the last
  bool verify = false;                     ///< compare every frame with one engine, on the first rank
  bool timeline = false;                   ///< keep what each rank did when
  std::string checkpoint;                  ///< where checkpoints go, each in the place of the one before
  std::size_t checkpoint_every = 0;        ///< so many frames, and at the end; 0: at the end alone
  std::string restart;                     ///< a checkpoint to go on from, in the place of frame 0
  RankOptions ranks;
};

/// The pairs of all ranks in one frame.
struct RankFrame {
  std::size_t frame = 0;
  std::uint64_t pairs = 0;
  std::uint64_t hash = 0;
};

/// Means over the updates after the first frame.
struct RankPhaseTimes {
  std::string name;
  bool is_wait = false;
  double milliseconds = 0;      ///< of the slowest rank
  double cpu_milliseconds = 0;  ///< of all ranks
};

struct RankRow {
  double owned = 0;
  double ghosts = 0;
  double messages = 0;
  double bytes = 0;
  double cpu_milliseconds = 0;  ///< without waits
};

/// The same on all ranks, but for the timeline.
struct RankReport {
  std::size_t bodies = 0;       ///< in the last frame
  std::size_t first_frame = 0;  ///< 0, or the checkpoint's
  std::size_t updates = 0;      ///< after that
  std::vector<RankFrame> frames;
  std::vector<RankPhaseTimes> phases;
  std::vector<RankRow> ranks;  ///< one a rank
  double moves = 0;            ///< told a frame, as the others, by all ranks
  double enters = 0;
  double leaves = 0;
  double adoptions = 0;
  double imbalance = 1;
  std::uint64_t cuts = 0;
  std::vector<Aabb> regions;         ///< of each rank, with infinite sides at the edge of the world
  std::size_t checkpoints = 0;       ///< that were written
  double checkpoint_ms = 0;          ///< that each took, in the mean
  std::size_t differing_frames = 0;  ///< with `verify`
  std::string first_difference;
  std::string timeline;  ///< of all ranks, on the first; events of Chrome's trace format
};

/// Collective over MPI_COMM_WORLD; every rank has a source of its own with the same frames. Errors, the same
/// on all ranks: those of the world and of checkpoints, and bad_input for a report frame beyond the last or a
/// checkpoint of another world than the source's.
Result<RankReport> run_on_ranks(FrameSource& source, const RankRunSettings& settings);

}  // namespace cellsweep::app
