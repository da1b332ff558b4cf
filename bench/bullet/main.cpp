/// @file
/// The program of the suite of Bullet's worlds: what the broadphase takes of whole frames, and of questions,
/// Bullet's own tree beside `stream`. These take turns, so that each row comes several times; all go into
/// out/bullet/bullet.json, too, unless rows are chosen.
#include <benchmark/benchmark.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"
#include "bench/bullet/bullet_world.h"
#include "bench/bullet/contenders.h"
#include "bench/bullet/question_rows.h"
#include "bench/bullet/timed_broadphase.h"
#include "bench/run_rows.h"
#include "bench/timed_row.h"
#include "report/quantile.h"

namespace cellsweep::bench {
namespace {

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
    state.counters["p99"] = 1e6 * report::quantile(seconds, 0.99);
    state.counters["frame"] = 1e6 * all / kFrames;
    state.counters["share"] = broadphase / all;
    state.counters["pairs"] = world.broadphase().getOverlappingPairCache()->getNumOverlappingPairs();
  }
}

void register_row(const BulletScene& scene, std::size_t bodies, const Contender& contender) {
  register_timed_row(text("bullet/", scene.name, "/", bodies, "/", contender.name),
                     [&scene, bodies, &contender](benchmark::State& state) {
                       run_row(state, scene.name, bodies, contender);
                     });
}

// A row of a thousand bodies takes half a second, one of twenty thousand up to half a minute.
int turns_with(std::size_t bodies) {
  if (bodies <= 1'000) return 9;
  return bodies <= 5'000 ? 5 : 3;
}

void register_rows() {
  for (const BulletScene& scene : kBulletScenes) {
    for (const std::size_t bodies : {std::size_t{1'000}, std::size_t{5'000}, std::size_t{20'000}}) {
      for_each_turn(turns_with(bodies),
                    [&](const Contender& contender) { register_row(scene, bodies, contender); });
    }
  }
}

}  // namespace
}  // namespace cellsweep::bench

int main(int argc, char** argv) {
  cellsweep::bench::register_rows();
  cellsweep::bench::register_questions();
  return cellsweep::bench::run_rows(argc, argv, {}, "out/bullet/bullet.json");
}
