/// @file
/// The times of a run of the suite of queries, read from Google Benchmark's JSON.
#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/status.h"

namespace cellsweep::bench {

/// What is asked where. World and kind count in kQueryWorlds and kQuestionKinds.
struct QueryCell {
  bool is_moved = false;  ///< asked after all bodies have moved
  std::size_t kind = 0;
  std::size_t bodies = 0;
  std::size_t world = 0;

  friend auto operator<=>(const QueryCell&, const QueryCell&) = default;
};

/// A frame of a world that moves. World counts in kQueryWorlds.
struct FrameCell {
  std::size_t bodies = 0;
  std::size_t percent = 0;  ///< of the bodies, that move
  std::size_t world = 0;

  friend auto operator<=>(const FrameCell&, const FrameCell&) = default;
};

/// Of one who follows it.
struct FrameTime {
  double us = 0;      ///< of a frame in the mean
  double ask_ns = 0;  ///< of a question
  std::vector<double> turns;
};

/// Of one who answers.
struct QueryTime {
  double ns = 0;   ///< for a question in the mean
  double p99 = 0;  ///< the 99th percentile; 0 where questions are not asked singly
  double move_ms = 0;
  bool moves_for_pairs = false;
  std::vector<double> turns;  ///< the seconds of each time that it was measured
};

struct QueryResults {
  std::map<QueryCell, std::map<std::string, QueryTime>> cells;
  std::map<FrameCell, std::map<std::string, FrameTime>> frames;
  std::string machine;  ///< what the file says of it
};

/// Adds what a file holds; rows that are there already make way. Rows that were errors are left out.
/// Errors: bad_input for what is no JSON of Google Benchmark.
Status add_query_results(std::string_view json, QueryResults& results);

}  // namespace cellsweep::bench
