/// @file
/// How even the frames of `stream` are.
#pragma once

namespace cellsweep::bench {

/// Registers rows `p99/stream/SCENE/N/dyn10` from 10,000 bodies on. A repetition takes 1,000 frames in which
/// 10 % of the bodies move; its time is their median. Counters: `p99`, the 99th percentile, in microseconds,
/// and `p99/median`, both of the frames in which the operating system took no core from the process
/// (getrusage counts that), and `frames`, how many those were.
void register_tail_suite();

}  // namespace cellsweep::bench
