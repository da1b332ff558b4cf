/// @file
/// Whole frames of Bullet's worlds: what the broadphase takes of them, and of questions, Bullet's own tree
/// beside `stream`.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/bullet/bullet_world.h"
#include "bench/bullet/contenders.h"
#include "bench/bullet/question_rows.h"
#include "bench/bullet/timed_broadphase.h"
#include "bench/context.h"
#include "bench/timed_row.h"
#include "report/quantile.h"

namespace {

using namespace cellsweep::bench;

/// The time of a row is the mean of what the broadphase takes in a frame. Boxes of bodies that fell for half
/// a second are on their way; later all have come to rest.
void run_row(benchmark::State& state, std::string_view scene, std::size_t bodies,
             const Contender& contender) {
  constexpr int kFramesBefore = 30;
  constexpr int kFrames = 120;
  for (auto _ : state) {
    auto timed = std::make_unique<TimedBroadphase>(contender.make());
    const TimedBroadphase& clock = *timed;
    BulletWorld world(scene, bodies, std::move(timed));
    for (int frame = 0; frame < kFramesBefore; ++frame) world.step();
    std::vector<double> seconds;
    const auto start = std::chrono::steady_clock::now();
    for (int frame = 0; frame < kFrames; ++frame) {
      world.step();
      seconds.push_back(clock.seconds());
    }
    const double all = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double broadphase = std::accumulate(seconds.begin(), seconds.end(), 0.0);
    state.SetIterationTime(broadphase / kFrames);
    state.counters["p99"] = 1e6 * cellsweep::report::quantile(seconds, 0.99);
    state.counters["frame"] = 1e6 * all / kFrames;
    state.counters["share"] = broadphase / all;
    state.counters["pairs"] = world.broadphase().getOverlappingPairCache()->getNumOverlappingPairs();
  }
}

void register_rows() {
  for (const BulletScene& scene : kBulletScenes) {
    for (const std::size_t bodies : {std::size_t{1'000}, std::size_t{5'000}, std::size_t{20'000}}) {
      for (const Contender& contender : contenders()) {
        const std::string name = "bullet/" + std::string(scene.name) + "/" + std::to_string(bodies) + "/" +
                                 std::string(contender.name);
        register_timed_row(name, [&scene, bodies, &contender](benchmark::State& state) {
          run_row(state, scene.name, bodies, contender);
        });
      }
    }
  }
}

}  // namespace

// Options given later win, so defaults go in front of the caller's.
int main(int argc, char** argv) {
  std::string defaults[] = {"--benchmark_repetitions=3", "--benchmark_report_aggregates_only=true",
                            "--benchmark_enable_random_interleaving=true"};
  std::vector<char*> arguments = {argv[0]};
  for (std::string& option : defaults) arguments.push_back(option.data());
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  add_context();
  register_rows();
  register_questions();
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
