/// @file
/// How far our queries are ahead of the best of the others, in Markdown.
#pragma once

#include <string>
#include <vector>

#include "bench/measured/measured_rows.h"
#include "bench/queries/table/query_results.h"

namespace cellsweep::bench {

/// Our row, asked singly, beside the fastest of the others.
struct QueryRatio {
  QueryCell cell;
  QueryTime own;
  std::string best;
  QueryTime best_time;

  double ratio() const { return ratio_in_turns(best_time.turns, own.turns); }
};

/// Of all cells in which `stream` and at least one other were measured, in their order.
std::vector<QueryRatio> query_ratios(const QueryResults& results);

/// A row for each kind of question, a column for each number of bodies: the geometric mean over the worlds,
/// and the smallest.
std::string query_summary(const QueryResults& results);

/// All cells, and everybody's times in them.
std::string query_cells(const QueryResults& results);

/// Rows of frames: how many times as long as `stream` each of the others takes, and a question.
std::string frame_cells(const QueryResults& results);

/// Rows after all bodies have moved: how long that took, and a question then.
std::string moved_cells(const QueryResults& results);

}  // namespace cellsweep::bench
