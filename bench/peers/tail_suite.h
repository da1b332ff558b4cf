/// @file
/// How even the frames of `stream` are.
#pragma once

namespace cellsweep::bench {

/// Registers rows `p99/stream_1/SCENE/N/dyn10` from 10,000 bodies on, in which 10 % of them move, and
/// `.../dyn100`, in which all do, from 1,000 on. A repetition takes 1,000 frames, of a million bodies 500,
/// after as many as the engine may take to get going, three times from the beginning: of each frame the
/// middle one of the three times counts (even_frames.h), and its time is their median. Counters: `p99`, the
/// 99th percentile, in microseconds; `p99/median` and `mean/median`, of each frame over the median of those
/// around it, and the former of the first run alone; all of the frames in which the operating system took no
/// core from the process (getrusage counts that), and `frames`, how many those were. One thread: a second
/// core that is away for a while says nothing about frames.
void register_tail_suite();

}  // namespace cellsweep::bench
