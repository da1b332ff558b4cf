/// @file
/// The benchmark program: Google Benchmark's options, our rows, and by default the median and spread of five
/// repetitions.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <string>
#include <vector>

#include "bench/context.h"
#include "bench/engine_suite.h"
#include "bench/threads_suite.h"
#include "bench/tuning_suite.h"
#include "report/all_engines.h"
#ifdef CELLSWEEP_CELL_ENGINES
#include "bench/cell_suite.h"
#include "bench/first_attempt_suite.h"
#include "bench/sort_suite.h"
#include "bench/timings_suite.h"
#endif

namespace {

// Options given later win, so defaults go in front of the caller's.
std::vector<char*> with_defaults(int argc, char** argv) {
  static std::string repetitions = "--benchmark_repetitions=5";
  static std::string aggregates = "--benchmark_report_aggregates_only=true";
  std::vector<char*> arguments = {argv[0], repetitions.data(), aggregates.data()};
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  return arguments;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<char*> arguments = with_defaults(argc, argv);
  int count = static_cast<int>(arguments.size());
  cellsweep::report::add_all_engines();
  cellsweep::bench::add_context();
  cellsweep::bench::register_engine_suite();
  cellsweep::bench::register_threads_suite();
  cellsweep::bench::register_tuning_suite();
#ifdef CELLSWEEP_CELL_ENGINES
  cellsweep::bench::register_cell_suite();
  cellsweep::bench::register_first_attempt_suite();
  cellsweep::bench::register_sort_suite();
  cellsweep::bench::register_timings_suite();
  cellsweep::bench::register_sizes_suite();
#endif
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
