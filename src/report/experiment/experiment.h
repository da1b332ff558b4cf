/// @file
/// The document's experiment (3.2.3, chapter 5): every curve at every size, measured in turns.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cellsweep/status.h"
#include "report/experiment/curves.h"

namespace cellsweep::report {

struct ExperimentSettings {
  std::vector<std::size_t> bodies = {64, 128, 256, 512, 1024};  ///< E1
  std::size_t frames = 1000;  ///< with nothing moving, and as many with some moving; 1 or more
  unsigned repetitions = 3;   ///< 1 or more
  std::uint64_t seed = 1;
  double moving = 0.1;  ///< share of the boxes that move
  /// On the simulated Cell, once, as its times are the same in every repetition: frames of each kind, at most
  /// `frames`; none without. A frame of 1,024 boxes takes a third of a second.
  std::size_t simulated_frames = 0;
  std::size_t simulated_most_bodies = 1024;  ///< larger sizes are left out there
};

/// Microseconds, over the repetitions.
struct Spread {
  double median = 0;
  double lowest = 0;
  double highest = 0;
  std::size_t repetitions = 0;
};

/// A step of an engine's update, in microseconds.
struct Step {
  std::string name;
  double microseconds = 0;
};

/// A curve that was measured.
struct CurveResult {
  Curve curve;
  std::map<std::size_t, PerMeasure<Spread>> points;  ///< by number of boxes
};

struct ExperimentResults {
  ExperimentSettings settings;
  std::vector<std::pair<std::string, std::string>> context;  ///< names and values: machine, compiler, commit
  std::vector<CurveResult> curves;                           ///< of engines that are in the table
  /// By engine and number of boxes, of the last repetition: the steps of the initial sort, and the median of
  /// each step over the frames in which some boxes move.
  std::map<std::pair<std::string, std::size_t>, std::vector<Step>> initial_steps;
  std::map<std::pair<std::string, std::size_t>, std::vector<Step>> moving_steps;
  std::map<std::size_t, std::size_t> pairs;  ///< overlapping pairs at the end, by number of boxes
  std::vector<std::string> left_out;         ///< a sentence for each point that an engine cannot have
  std::vector<std::string> wrong;  ///< a sentence for each run that ended with other pairs than the oracle's
  std::string interrupted;         ///< a sentence, when not all runs were made

  /// The median of a curve at a size; nothing when it has no such point.
  std::optional<double> at(std::string_view curve, std::size_t bodies, Measure measure) const;
};

/// Runs scene `paper`: for each repetition and size, each engine takes its turn, in an order that rotates.
/// Each run's last pairs are compared with the oracle's. Times are of the engine's own work, without what it
/// marks as set-up. An interrupted experiment ends after the frame that it is at, and keeps the runs that
/// were complete. Errors: bad_option for no sizes, sizes of 0 or more than 2^24, no frames or repetitions;
/// those of the engines.
Result<ExperimentResults> run_experiment(const ExperimentSettings& settings);

}  // namespace cellsweep::report
