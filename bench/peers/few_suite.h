/// @file
/// What a few movers among many bodies cost.
#pragma once

namespace cellsweep::bench {

/// Registers rows `few/PEER/SCENE/N/K`: in each frame K other bodies of N move a little, and the clock runs
/// until the peer knows its pairs; `stream` has said by then which began and ended. Nobody asks for the list
/// of all, which would be a copy of it. Peers are those whose work follows what moves: `stream` on one thread
/// and Bullet's trees.
///
/// After a hundred frames, in which a world that was entered as a whole comes to rest, a repetition takes
/// 6,000, or as many as fit into two seconds; its time is their mean. Counters: `median`, `p99` and `slowest`
/// in microseconds, `frames` (as in the rows `p99/`, those in which the system took no core away), and
/// `pairs` after the last one; the label is their hash, compared with the oracle's.
void register_few_suite();

}  // namespace cellsweep::bench
