/// @file
/// A row of a suite that keeps time itself.
#pragma once

#include <benchmark/benchmark.h>

#include <string>

namespace cellsweep::bench {

/// `run(state)` does all of it once and says how many seconds it took, which are shown as microseconds.
template <class Run>
void register_timed_row(const std::string& name, const Run& run) {
  benchmark::RegisterBenchmark(name.c_str(), run)
      ->UseManualTime()
      ->Iterations(1)
      ->Unit(benchmark::kMicrosecond);
}

}  // namespace cellsweep::bench
