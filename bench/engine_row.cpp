#include "bench/engine_row.h"

#include <memory>
#include <optional>
#include <vector>

#include "report/engine_settings.h"
#include "report/frame_clock.h"
#include "report/hand_over.h"
#include "report/verify.h"

namespace cellsweep::bench {
namespace {

// Comparing a frame with the oracle takes time with the square of the bodies.
constexpr std::size_t kUpdatesToCheck = 8;
constexpr std::size_t kBodiesToCheckLong = 10'000;

report::Shape shape_of(const EngineRow& row) {
  return report::shape_of(row.settings);
}

// A frame that fails is the row's last word: check() has been through the same ones.
double seconds_of(const Result<report::TimedFrame>& frame) {
  return frame ? frame->time.work_ms() / 1000 : 0;
}

double time_initial(const EngineRow& row, const FrameSource& source, Broadphase& engine) {
  engine = std::move(*make_broadphase(row.engine, row.settings));
  return seconds_of(
      report::time_frame(engine, [&] { return report::insert_all(engine, source, shape_of(row)); }));
}

double time_next_frame(const EngineRow& row, FrameSource& source, Broadphase& engine) {
  if (row.mode == Mode::moving) source.advance();
  return seconds_of(
      report::time_frame(engine, [&] { return report::hand_over_changes(engine, source, shape_of(row)); }));
}

// Empty when the engine equals the oracle on the first frames of the row, else what is wrong.
std::string check(const EngineRow& row) {
  if (report::value_of(row.settings, "literal") == "true") return "";
  auto source = make_scene_frames(row.scene);
  auto engine = make_broadphase(row.engine, row.settings);
  if (!source) return source.status().message;
  if (!engine) return engine.status().message;
  std::vector<report::FedEngine> engines;
  engines.push_back({std::move(*engine), shape_of(row)});
  const std::size_t long_check = row.scene.bodies <= kBodiesToCheckLong ? kUpdatesToCheck : 1;
  const auto verdicts = report::verify_engines(engines, **source, row.mode == Mode::initial ? 0 : long_check);
  if (!verdicts) return verdicts.status().message;
  if (verdicts->front().first) return report::describe(*verdicts->front().first);
  return verdicts->front().exact() ? "" : "began or ended pairs are not the difference of the frames";
}

// `fault` is what check() said, once for all repetitions: with many bodies it takes longer than they do.
void run_row(benchmark::State& state, const EngineRow& row, std::optional<std::string>& fault) {
  if (!fault) fault = check(row);
  if (!fault->empty()) return state.SkipWithError(fault->c_str());
  auto source = std::move(*make_scene_frames(row.scene));
  Broadphase engine;
  if (row.mode != Mode::initial) time_initial(row, *source, engine);
  for (auto _ : state) {
    state.SetIterationTime(row.mode == Mode::initial ? time_initial(row, *source, engine)
                                                     : time_next_frame(row, *source, engine));
  }
  const auto bodies = static_cast<double>(row.scene.bodies);
  state.counters["pairs"] = static_cast<double>(engine.pairs().size());
  state.counters["boxes/s"] = benchmark::Counter(bodies, benchmark::Counter::kIsIterationInvariantRate);
  state.SetLabel(hash_text(pair_set_hash(engine.pairs())));
}

}  // namespace

void register_engine_row(const std::string& name, const EngineRow& row) {
  const auto fault = std::make_shared<std::optional<std::string>>();
  benchmark::RegisterBenchmark(name.c_str(),
                               [row, fault](benchmark::State& state) { run_row(state, row, *fault); })
      ->UseManualTime()
      ->Unit(benchmark::kMicrosecond);
}

}  // namespace cellsweep::bench
