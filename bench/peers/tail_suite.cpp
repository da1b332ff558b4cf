#include "bench/peers/tail_suite.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "base/text.h"
#include "bench/peers/peer_run.h"
#include "bench/peers/peer_table.h"
#include "bench/peers/undisturbed_frames.h"
#include "bench/timed_row.h"
#include "report/quantile.h"

namespace cellsweep::bench {
namespace {

/// A million bodies take a quarter of a minute for them.
std::size_t frames_with(std::size_t bodies) {
  return bodies < 1'000'000 ? 1'000 : 500;
}

constexpr std::size_t kFramesBefore = 24;

/// Each frame over the median of some hundred around it: a world that dissolves takes less with each frame,
/// and that is not uneven.
std::vector<double> over_medians_nearby(std::span<const double> frames) {
  constexpr std::size_t kNearby = 101;
  const std::size_t count = std::min(kNearby, frames.size());
  std::vector<double> ratios;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const std::size_t first = std::min(i - std::min(i, count / 2), frames.size() - count);
    const auto nearby = frames.subspan(first, count);
    ratios.push_back(frames[i] / report::quantile({nearby.begin(), nearby.end()}, 0.5));
  }
  return ratios;
}

void run_row(benchmark::State& state, const PeerInfo& peer, const PeerSetting& setting) {
  PeerRun run(peer, setting);
  UndisturbedFrames frames;
  const std::vector<double>& undisturbed = frames.seconds();
  const std::size_t count = frames_with(setting.bodies);
  for (auto _ : state) {
    for (std::size_t i = 0; i < kFramesBefore; ++i) run.next_frame();
    for (std::size_t i = 0; i < count; ++i) frames.add([&] { return run.next_frame(); });
    state.SetIterationTime(report::quantile(undisturbed, 0.5));
  }
  if (undisturbed.empty()) return state.SkipWithError("no frame without an involuntary switch");
  const std::vector<double> ratios = over_medians_nearby(undisturbed);
  state.counters["p99"] = 1e6 * report::quantile(undisturbed, 0.99);
  state.counters["p99/median"] = report::quantile(ratios, 0.99);
  state.counters["mean/median"] =
      std::accumulate(ratios.begin(), ratios.end(), 0.0) / static_cast<double>(ratios.size());
  state.counters["frames"] = static_cast<double>(undisturbed.size());
}

void register_row(const PeerInfo& peer, const PeerSetting& setting) {
  const std::string name =
      text("p99/", peer.name, "/", setting.scene, "/", setting.bodies, "/", info_of(setting.mode).name);
  register_timed_row(name, [&peer, setting](benchmark::State& state) { run_row(state, peer, setting); });
}

}  // namespace

void register_tail_suite() {
  for (const PeerInfo& peer : peer_table()) {
    if (peer.name != "stream_1") continue;
    for (const std::string_view scene : std::span(kPeerScenes).first(kScenesThatMoveAsTold)) {
      for (const std::size_t bodies : kPeerBodies) {
        if (bodies >= 10'000) register_row(peer, {std::string(scene), bodies, PeerMode::dyn10});
        register_row(peer, {std::string(scene), bodies, PeerMode::dyn100});
      }
    }
  }
}

}  // namespace cellsweep::bench
