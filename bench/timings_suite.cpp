#include "bench/timings_suite.h"

#include <algorithm>
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "bench/engine_row.h"
#include "bench/timed_row.h"
#include "report/all_engines.h"
#include "report/frame_clock.h"
#include "report/hand_over.h"
#include "report/oracle.h"
#include "report/quantile.h"

namespace cellsweep::bench {
namespace {

constexpr std::array kEngines = {"control", "cell-paper", "cell-brute", "cell-resident"};
constexpr std::array<std::size_t, 7> kSizes = {64, 128, 256, 512, 1024, 2048, 3500};
constexpr std::size_t kBodies = 1024;
constexpr std::size_t kUpdates = 1000;

double longest_spu_us(const Broadphase& engine) {
  const auto spes = report::statistics_of_spes(engine);
  return spes ? 1000 * spes->longest_spu_ms : 0;
}

// Microseconds of handing over and update().
double frame_us(Broadphase& engine, const std::function<Status()>& hand_over) {
  const auto frame = report::time_frame(engine, hand_over);
  return frame ? 1000 * frame->time.work_ms() : 0;
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
    Broadphase engine = std::move(*make_broadphase(name));
    first.push_back(frame_us(engine, [&] { return report::insert_all(engine, source); }));
  }
  return report::quantile(first, 0.5);
}

// The source stands still until the moving frames.
Run run_engine_through(const std::string& name) {
  Run run;
  Broadphase engine = std::move(*make_broadphase(name));
  auto source = std::move(*make_scene_frames({.bodies = kBodies, .moving = 0.1}));
  run.initial = initial_us(name, *source);
  frame_us(engine, [&] { return report::insert_all(engine, *source); });
  for (std::size_t i = 0; i < kUpdates; ++i) run.still.push_back(frame_us(engine, report::hand_over_nothing));
  for (std::size_t i = 0; i < kUpdates; ++i) {
    source->advance();
    run.moving.push_back(frame_us(engine, [&] { return report::hand_over_changes(engine, *source); }));
    run.longest_spu = std::max(run.longest_spu, longest_spu_us(engine));
  }
  const std::vector<Pair> truth = report::oracle_pairs(*source);
  run.exact = std::equal(engine.pairs().begin(), engine.pairs().end(), truth.begin(), truth.end());
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
    register_timed_row("timings/" + engine, [engine](benchmark::State& state) { run_row(state, engine); });
  }
}

void register_sizes_suite() {
  for (const ModeInfo& mode : kModes) {
    if (mode.mode == Mode::settled) continue;
    for (const std::size_t bodies : kSizes) {
      for (const std::string engine : kEngines) {
        if (bodies > make_broadphase(engine)->capacity().bodies) continue;
        register_engine_row("sizes/" + std::string(mode.name) + "/" + std::to_string(bodies) + "/" + engine,
                            {engine, {}, SceneSettings{.bodies = bodies, .moving = mode.moving}, mode.mode});
      }
    }
  }
}

}  // namespace cellsweep::bench
