#include "bench/timings_suite.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "bench/engine_row.h"
#include "engines/oracle/brute_force.h"
#include "report/quantile.h"
#include "report/run_engine.h"

namespace cellsweep::bench {
namespace {

constexpr std::array kEngines = {"control", "cell-paper", "cell-brute", "cell-resident"};
constexpr std::array<std::size_t, 7> kSizes = {64, 128, 256, 512, 1024, 2048, 3500};
constexpr std::size_t kBodies = 1024;
constexpr std::size_t kUpdates = 1000;

double longest_spu_us(const Broadphase& engine) {
  for (const Counter& counter : engine.statistics().counters) {
    if (counter.name == "longest spu of this update, ns") return static_cast<double>(counter.value) / 1000;
  }
  return 0;
}

/// One run of an engine: times in microseconds.
struct Run {
  double initial = 0;
  std::vector<double> still;
  std::vector<double> moving;
  double longest_spu = 0;
  bool exact = false;
};

/// Median of the first frames of a few engines: one such frame is short, and may meet anything.
double initial_us(const std::string& name, const FrameSource& source) {
  std::vector<double> first;
  for (int i = 0; i < 9; ++i) {
    auto engine = std::move(*make_engine(name));
    first.push_back(1e6 * seconds_of_frame(*engine, [&] { return report::insert_all(*engine, source); }));
  }
  return report::quantile(first, 0.5);
}

// The source stands still until the moving frames.
Run run_engine_through(const std::string& name) {
  Run run;
  auto engine = std::move(*make_engine(name));
  auto source = std::move(*make_scene_frames({.bodies = kBodies, .moving = 0.1}));
  run.initial = initial_us(name, *source);
  seconds_of_frame(*engine, [&] { return report::insert_all(*engine, *source); });
  for (std::size_t i = 0; i < kUpdates; ++i)
    run.still.push_back(1e6 * seconds_of_frame(*engine, [] { return Status{}; }));
  for (std::size_t i = 0; i < kUpdates; ++i) {
    source->advance();
    run.moving.push_back(1e6 *
                         seconds_of_frame(*engine, [&] { return report::move_changed(*engine, *source); }));
    run.longest_spu = std::max(run.longest_spu, longest_spu_us(*engine));
  }
  std::vector<Pair> pairs(engine->pairs().begin(), engine->pairs().end());
  std::sort(pairs.begin(), pairs.end());
  run.exact = pairs == brute_force_pairs(source->boxes());
  return run;
}

void run_row(benchmark::State& state, const std::string& engine) {
  for (auto _ : state) {
    const Run run = run_engine_through(engine);
    if (!run.exact) return state.SkipWithError("the pairs are not the oracle's");
    state.SetIterationTime(report::quantile(run.moving, 0.5) / 1e6);
    state.counters["initial"] = run.initial;
    state.counters["static"] = report::quantile(run.still, 0.5);
    state.counters["moving10"] = report::quantile(run.moving, 0.5);
    state.counters["longest"] = report::quantile(run.moving, 1.0);
    if (run.longest_spu != 0) state.counters["longest_spu"] = run.longest_spu;
  }
}

}  // namespace

void register_timings_suite() {
  for (const std::string engine : kEngines) {
    benchmark::RegisterBenchmark(("timings/" + engine).c_str(),
                                 [engine](benchmark::State& state) { run_row(state, engine); })
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kMicrosecond);
  }
}

void register_sizes_suite() {
  for (const ModeInfo& mode : kModes) {
    if (mode.mode == Mode::settled) continue;
    for (const std::size_t bodies : kSizes) {
      for (const std::string engine : kEngines) {
        if (bodies > (*make_engine(engine))->capacity().bodies) continue;
        register_engine_row("sizes/" + std::string(mode.name) + "/" + std::to_string(bodies) + "/" + engine,
                            {engine, {}, SceneSettings{.bodies = bodies, .moving = mode.moving}, mode.mode});
      }
    }
  }
}

}  // namespace cellsweep::bench
