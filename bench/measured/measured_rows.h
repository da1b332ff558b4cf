/// @file
/// The rows of a run of a suite, read from Google Benchmark's JSON.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/status.h"

namespace cellsweep::bench {

/// A row that was measured once, in several turns, or in repetitions: the measurement in the middle.
struct MeasuredRow {
  std::vector<std::string> parts;  ///< of its name, between the slashes; at least one
  double seconds = 0;
  double spread = 0;          ///< standard deviation of the measurements over their mean; 0 for a single one
  std::vector<double> turns;  ///< all measurements, in the order of the file
  std::map<std::string, double> counters;

  /// A counter by its name; 0 where the row has none.
  double counter(const std::string& name) const;
};

struct MeasuredRows {
  std::vector<MeasuredRow> rows;  ///< by their names, in the order in which these first come
  std::string machine;            ///< what the file says of it; empty when that is nothing
};

/// How many times as long one took as another: of the turns that both had the quotient in the middle. A
/// machine whose speed changes from turn to turn changes it little. Where one was measured more often than
/// the other it is that of the measurements in the middle. Neither is empty.
double ratio_in_turns(std::span<const double> one, std::span<const double> other);

/// Rows that were errors are left out. Errors: bad_input for what is no JSON of Google Benchmark.
Result<MeasuredRows> read_measured_rows(std::string_view text_of_file);

/// The number of a part of a name; none when it is not one.
std::optional<std::size_t> number_in(std::string_view part);

}  // namespace cellsweep::bench
