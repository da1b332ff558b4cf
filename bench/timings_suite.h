/// @file
/// The suites behind the tables of docs/experiment.md: whole runs of 1,000 frames, and which engine wins at
/// which size.
#pragma once

namespace cellsweep::bench {

/// Registers rows `timings/ENGINE` of scene `paper` with 1,024 boxes. One repetition makes an engine, enters
/// all boxes, updates 1,000 frames in which nothing moves and 1,000 in which 10 % move. Counters, in
/// microseconds: `initial`, `static` (median), `moving10` (median), `longest` of the moving frames, and
/// `longest_spu`, the longest time an SPU of cell-paper worked in one of them; engines without such a number
/// have none. The last frame's pairs are compared with the oracle. With
/// --benchmark_enable_random_interleaving the engines take turns.
void register_timings_suite();

/// Registers rows `sizes/MODE/N/ENGINE` of scene `paper` from 64 boxes to what the Cell engines hold, checked
/// and timed as all engine rows.
void register_sizes_suite();

}  // namespace cellsweep::bench
