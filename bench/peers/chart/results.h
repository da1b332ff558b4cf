/// @file
/// The times of a run of the suite of peers, read from Google Benchmark's JSON.
#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/status.h"

namespace cellsweep::bench {

/// A combination that peers are compared in. Scene and mode count in kPeerScenes and kPeerModes.
struct CellKey {
  std::size_t scene = 0;
  std::size_t bodies = 0;
  std::size_t mode = 0;

  friend auto operator<=>(const CellKey&, const CellKey&) = default;
};

struct PeerTime {
  double seconds = 0;  ///< the mean of the frames of a repetition; of repetitions the one in the middle
  double median = 0;   ///< seconds, of the frames; 0 in files that do not have it
  double p99 = 0;      ///< the 99th percentile, the same way
  double spread = 0;   ///< standard deviation of the repetitions over their mean
  double pairs = 0;
  double missing = 0;
  double extra = 0;
  std::vector<double> turns;  ///< the seconds of each time that it was measured

  bool exact() const { return missing == 0 && extra == 0; }
};

/// The 99th percentile of `stream`'s frames over their median.
struct Tail {
  CellKey cell;
  double median_seconds = 0;
  double p99_over_median = 0;
  double mean_over_median = 0;
  double frames = 0;
};

struct PeerResults {
  std::map<CellKey, std::map<std::string, PeerTime>> cells;
  std::vector<std::string> peers;  ///< in the order of the file
  std::vector<Tail> tails;
  std::string machine;  ///< what the file says of it
};

/// Adds what a file holds to the results; rows that are there already stay. Of a row that was measured
/// several times the measurement in the middle is used. Errors: bad_input for what is no JSON of Google
/// Benchmark.
Status add_results(std::string_view json, PeerResults& results);

}  // namespace cellsweep::bench
