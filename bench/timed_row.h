/// @file
/// A row of a suite that keeps time itself.
#pragma once

#include <benchmark/benchmark.h>

#include <string>

namespace cellsweep::bench {

/// `run(state)` does all of it once and says how many seconds it took, which are shown in `unit`.
template <class Run>
benchmark::internal::Benchmark* register_timed_row(const std::string& name, const Run& run,
                                                   benchmark::TimeUnit unit = benchmark::kMicrosecond) {
  return benchmark::RegisterBenchmark(name.c_str(), run)->UseManualTime()->Iterations(1)->Unit(unit);
}

}  // namespace cellsweep::bench
