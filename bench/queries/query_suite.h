/// @file
/// The suite of queries: world x number of bodies x kind of question x who answers.
#pragma once

#include <cstddef>
#include <span>

#include "bench/queries/query_world.h"

namespace cellsweep::bench {

struct QuerySuite {
  std::span<const std::size_t> bodies = kQueryBodies;
  std::size_t questions = 8'192;
  std::size_t turns = 3;  ///< of those that are compared, within seconds
};

/// Registers a row `queries/WORLD/N/KIND/NAME` for everybody who answers that kind in that world, and
/// `moved/WORLD/N/KIND/NAME` for three kinds, asked after all bodies have moved four times.
///
/// Before a row is timed its answers are compared (query_check.h says how far those of trees in floats may be
/// off): a row that is wrong is an error. A row's time is that of a question in the mean (query_clock.h).
/// Counters: `answers` to all questions, `p99` in nanoseconds where questions are asked singly; in rows
/// `moved` also `move`, the milliseconds after which the moved bodies could be asked about, of four times the
/// fastest, and whether that is done for the `pairs` anyway. The label is the hash of who was an answer to
/// what: of nearest ones and firsts that are equally far, any may be named.
void register_query_suite(const QuerySuite& suite);

}  // namespace cellsweep::bench
