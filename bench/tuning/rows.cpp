#include "bench/tuning/rows.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

#include "cellsweep/world/scene.h"
#include "engines/stream/kernels/kernel.h"

namespace cellsweep::bench {

void register_tuning_row(const std::string& name, const std::function<Measured()>& measure) {
  benchmark::RegisterBenchmark(("tuning/" + name).c_str(),
                               [=](benchmark::State& state) {
                                 Measured measured;
                                 for (auto _ : state) {
                                   measured = measure();
                                   state.SetIterationTime(1e-3);
                                 }
                                 for (const auto& [counter, value] : measured)
                                   state.counters[std::string(counter)] = value;
                               })
      ->UseManualTime()
      ->Iterations(3);
}

double seconds_of(const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double quickest_seconds_of(int times, const std::function<void()>& work) {
  double quickest = seconds_of(work);
  for (int i = 1; i < times; ++i) quickest = std::min(quickest, seconds_of(work));
  return quickest;
}

std::unique_ptr<FrameSource> uniform(std::size_t bodies, double moving) {
  return std::move(*make_scene_frames({.scene = "uniform", .bodies = bodies, .moving = moving}));
}

Cells::Cells() : tree(crew, *stream::find_kernels(VectorIsa::best)) {}

double Cells::build_seconds(std::span<const Aabb> boxes) {
  return seconds_of([&] { tree.build({boxes.data(), boxes.size()}); });
}

}  // namespace cellsweep::bench
