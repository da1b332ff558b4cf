#include "bench/first_attempt_suite.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <memory>
#include <string>

#include "bench/engine_row.h"
#include "bench/first_attempt.h"
#include "report/oracle.h"

namespace cellsweep::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_of_run(FirstAttempt& attempt, const FrameSource& source) {
  const Clock::time_point start = Clock::now();
  const bool ran = attempt.run(source.boxes()).ok();
  benchmark::DoNotOptimize(ran);
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// Every frame's events have to be taken in, or the count at the end is not that of the last frame; that is
// not timed.
void run_row(benchmark::State& state, std::size_t bodies, const ModeInfo& mode) {
  const auto source = std::move(*make_scene_frames(SceneSettings{.bodies = bodies, .moving = mode.moving}));
  auto attempt = std::move(*FirstAttempt::make(bodies));
  std::size_t pairs = 0;
  if (mode.mode != Mode::initial) {
    seconds_of_run(*attempt, *source);
    pairs = attempt->count_pairs();
  }
  for (auto _ : state) {
    if (mode.mode == Mode::initial) attempt = std::move(*FirstAttempt::make(bodies));
    if (mode.mode == Mode::moving) source->advance();
    state.SetIterationTime(seconds_of_run(*attempt, *source));
    pairs = attempt->count_pairs();
  }
  if (pairs != report::oracle_pairs(*source).size())
    return state.SkipWithError("the pairs are not the oracle's");
  state.counters["pairs"] = static_cast<double>(pairs);
  state.counters["events"] = static_cast<double>(attempt->events());
}

}  // namespace

void register_first_attempt_suite() {
  for (const std::size_t bodies : {64U, 128U, 256U, 512U, 1024U}) {
    for (const ModeInfo& mode : kModes) {
      const std::string name = "first_attempt/paper/" + std::to_string(bodies) + "/" + std::string(mode.name);
      benchmark::RegisterBenchmark(name.c_str(),
                                   [=](benchmark::State& state) { run_row(state, bodies, mode); })
          ->UseManualTime()
          ->Unit(benchmark::kMicrosecond);
    }
  }
}

}  // namespace cellsweep::bench
