/// @file
/// The benchmark program: Google Benchmark's options, our rows, and by default the median and spread of five
/// repetitions.
#include "bench/engine_suite.h"
#include "bench/run_rows.h"
#include "bench/threads_suite.h"
#include "bench/tuning_suite.h"
#include "report/all_engines.h"
#ifdef CELLSWEEP_CELL_ENGINES
#include "bench/cell_suite.h"
#include "bench/first_attempt_suite.h"
#include "bench/sort_suite.h"
#include "bench/timings_suite.h"
#endif

int main(int argc, char** argv) {
  cellsweep::report::add_all_engines();
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
  return cellsweep::bench::run_rows(argc, argv,
                                    {"--benchmark_repetitions=5", "--benchmark_report_aggregates_only=true"});
}
