#include "bench/engine_suite.h"

#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <string>
#include <string_view>

#include "cellsweep/engines.h"
#include "cellsweep/scene.h"
#include "report/run_engine.h"
#include "report/verify.h"

namespace cellsweep::bench {
namespace {

constexpr std::array<std::size_t, 9> kBodies = {64, 128, 256, 512, 1024, 4096, 10'000, 100'000, 1'000'000};

// Comparing a frame with the oracle takes time with the square of the bodies.
constexpr std::size_t kUpdatesToCheck = 8;
constexpr std::size_t kBodiesToCheckLong = 10'000;

enum class Mode { initial, settled, moving };

struct ModeInfo {
  std::string_view name;
  Mode mode;
  double moving;
};

constexpr std::array kModes = {
    ModeInfo{"initial", Mode::initial, 0.0}, ModeInfo{"static", Mode::settled, 0.0},
    ModeInfo{"moving10", Mode::moving, 0.1}, ModeInfo{"moving100", Mode::moving, 1.0}};

struct Row {
  std::string engine;
  SceneSettings scene;
  Mode mode;
};

using Clock = std::chrono::steady_clock;

// Runs a frame and returns its seconds; set-up phases are taken out.
template <class HandOver>
double seconds_of_frame(Broadphase& engine, HandOver&& hand_over) {
  const Clock::time_point start = Clock::now();
  hand_over();
  const bool updated = engine.update().ok();
  double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  benchmark::DoNotOptimize(updated);
  for (const Phase& phase : engine.statistics().phases) {
    if (phase.setup) seconds -= phase.milliseconds / 1000;
  }
  return seconds;
}

double time_initial(const Row& row, const FrameSource& source, std::unique_ptr<Broadphase>& engine) {
  engine = std::move(*make_engine(row.engine));
  return seconds_of_frame(*engine,
                          [&] { benchmark::DoNotOptimize(report::insert_all(*engine, source).ok()); });
}

double time_next_frame(const Row& row, FrameSource& source, Broadphase& engine) {
  if (row.mode == Mode::moving) source.advance();
  return seconds_of_frame(engine,
                          [&] { benchmark::DoNotOptimize(report::move_changed(engine, source).ok()); });
}

// Empty when the engine equals the oracle on the first frames of the row, else what is wrong.
std::string check(const Row& row) {
  auto source = make_scene_frames(row.scene);
  auto engine = make_engine(row.engine);
  if (!source) return source.status().message;
  if (!engine) return engine.status().message;
  std::vector<std::unique_ptr<Broadphase>> engines;
  engines.push_back(std::move(*engine));
  const std::size_t long_check = row.scene.bodies <= kBodiesToCheckLong ? kUpdatesToCheck : 1;
  const auto verdicts = report::verify_engines(engines, **source, row.mode == Mode::initial ? 0 : long_check);
  if (!verdicts) return verdicts.status().message;
  if (verdicts->front().first) return report::describe(*verdicts->front().first);
  return verdicts->front().exact() ? "" : "began or ended pairs are not the difference of the frames";
}

void run_row(benchmark::State& state, const Row& row) {
  if (const std::string fault = check(row); !fault.empty()) return state.SkipWithError(fault.c_str());
  auto source = std::move(*make_scene_frames(row.scene));
  std::unique_ptr<Broadphase> engine;
  if (row.mode != Mode::initial) time_initial(row, *source, engine);
  for (auto _ : state) {
    state.SetIterationTime(row.mode == Mode::initial ? time_initial(row, *source, engine)
                                                     : time_next_frame(row, *source, *engine));
  }
  const auto bodies = static_cast<double>(row.scene.bodies);
  state.counters["pairs"] = static_cast<double>(engine->pairs().size());
  state.counters["boxes/s"] = benchmark::Counter(bodies, benchmark::Counter::kIsIterationInvariantRate);
  state.SetLabel(hash_text(pair_set_hash(engine->pairs())));
}

void register_row(const EngineInfo& engine, const SceneInfo& scene, std::size_t bodies,
                  const ModeInfo& mode) {
  const Row row{std::string(engine.name),
                SceneSettings{.scene = std::string(scene.name), .bodies = bodies, .moving = mode.moving},
                mode.mode};
  const std::string name = "engine/" + row.engine + "/" + row.scene.scene + "/" + std::to_string(bodies) +
                           "/" + std::string(mode.name);
  benchmark::RegisterBenchmark(name.c_str(), [row](benchmark::State& state) { run_row(state, row); })
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond);
}

}  // namespace

void register_engine_suite() {
  for (const EngineInfo& engine : engine_table()) {
    const auto sample = make_engine(engine.name);
    if (!sample) continue;
    for (const SceneInfo& scene : scene_table()) {
      for (const std::size_t bodies : kBodies) {
        if (bodies > (*sample)->capacity().bodies) continue;
        for (const ModeInfo& mode : kModes) register_row(engine, scene, bodies, mode);
      }
    }
  }
}

}  // namespace cellsweep::bench
