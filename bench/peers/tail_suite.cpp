#include "bench/peers/tail_suite.h"

#include <benchmark/benchmark.h>

#include <array>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "base/text.h"
#include "bench/peers/even_frames.h"
#include "bench/peers/peer_run.h"
#include "bench/peers/peer_table.h"
#include "bench/peers/timed_frame.h"
#include "bench/timed_row.h"
#include "report/quantile.h"

namespace cellsweep::bench {
namespace {

/// A million bodies take a quarter of a minute for them.
std::size_t frames_with(std::size_t bodies) {
  return bodies < 1'000'000 ? 1'000 : 500;
}

constexpr std::size_t kFramesBefore = 24;

std::vector<double> run_through(const PeerInfo& peer, const PeerSetting& setting) {
  PeerRun run(peer, setting);
  for (std::size_t i = 0; i < kFramesBefore; ++i) run.next_frame();
  std::vector<double> frames(frames_with(setting.bodies));
  for (double& seconds : frames) {
    const TimedFrame frame = time_frame([&] { return run.next_frame(); });
    seconds = frame.is_undisturbed ? frame.seconds : kDisturbed;
  }
  return frames;
}

void run_row(benchmark::State& state, const PeerInfo& peer, const PeerSetting& setting) {
  std::array<std::vector<double>, 3> runs;
  std::vector<double> frames;
  for (auto _ : state) {
    for (std::vector<double>& run : runs) run = run_through(peer, setting);
    frames = middle_of(runs);
    state.SetIterationTime(report::quantile(frames, 0.5));
  }
  if (frames.empty()) return state.SkipWithError("each frame had an involuntary switch in two of three runs");
  const std::vector<double> ratios = over_medians_nearby(frames);
  std::erase(runs[0], kDisturbed);
  state.counters["p99"] = 1e6 * report::quantile(frames, 0.99);
  state.counters["p99/median"] = report::quantile(ratios, 0.99);
  state.counters["p99/median of one run"] = report::quantile(over_medians_nearby(runs[0]), 0.99);
  state.counters["mean/median"] =
      std::accumulate(ratios.begin(), ratios.end(), 0.0) / static_cast<double>(ratios.size());
  state.counters["frames"] = static_cast<double>(frames.size());
}

void register_row(const PeerInfo& peer, const PeerSetting& setting) {
  const std::string name =
      text("p99/", peer.name, "/", setting.scene, "/", setting.bodies, "/", info_of(setting.mode).name);
  for (std::size_t turn = 0; turn < turns_with(setting.bodies); ++turn) {
    register_timed_row(name, [&peer, setting](benchmark::State& state) { run_row(state, peer, setting); });
  }
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
