#include "bench/peers/peer_suite.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bench/peers/peer_check.h"
#include "bench/peers/peer_table.h"
#include "report/quantile.h"

namespace cellsweep::bench {
namespace {

constexpr std::size_t kBodiesToCheck = 1'000;
constexpr std::size_t kFramesToCheck = 8;

// Once for each peer, scene and mode, whatever the repetitions.
Mismatch check_once(const PeerInfo& peer, const PeerSetting& setting) {
  static std::map<std::tuple<std::string, std::string, PeerMode>, Mismatch> known;
  const auto [entry, is_new] = known.try_emplace({std::string(peer.name), setting.scene, setting.mode});
  if (is_new) {
    entry->second = check_peer(peer, {setting.scene, kBodiesToCheck, setting.mode}, kFramesToCheck);
  }
  return entry->second;
}

// The list is sorted and compared only when count or hash differ.
Mismatch check_last_frame(const PeerRun& run, const PeerSetting& setting, std::size_t frame) {
  const PairSum expected = oracle_sum(setting, frame, run.boxes());
  std::vector<Pair> pairs = run.pairs();
  if (expected == PairSum{pairs.size(), pair_set_hash(pairs)}) return {};
  return compare_with_oracle(run.boxes(), std::move(pairs));
}

// Slow peers need not take as many frames.
std::vector<double> time_frames(PeerRun& run, const PeerSetting& setting) {
  constexpr double kLongEnough = 0.4;  // seconds
  constexpr std::size_t kFewest = 3;
  // An engine that keeps something from frame to frame first learns that bodies move.
  const std::size_t frames_before = info_of(setting.mode).moving > 0 ? 2 : 0;
  for (std::size_t i = 0; i < frames_before; ++i) run.next_frame();
  std::vector<double> seconds;
  double sum = 0;
  while (seconds.size() < frames_of(setting) && (sum < kLongEnough || seconds.size() < kFewest)) {
    seconds.push_back(run.next_frame());
    sum += seconds.back();
  }
  return seconds;
}

void run_row(benchmark::State& state, const PeerInfo& peer, const PeerSetting& setting) {
  Mismatch mismatch;
  if (peer.finds_pairs) mismatch = check_once(peer, setting);
  PeerRun run(peer, setting);
  std::vector<double> seconds;
  for (auto _ : state) {
    seconds = time_frames(run, setting);
    state.SetIterationTime(report::quantile(seconds, 0.5));
  }
  state.counters["pairs"] = static_cast<double>(run.listed().size());
  state.counters["frames"] = static_cast<double>(seconds.size());
  state.counters["slowest"] = 1e6 * report::quantile(seconds, 1.0);
  if (!peer.finds_pairs) return;
  const Mismatch last = check_last_frame(run, setting, seconds.size());
  mismatch.missing += last.missing;
  mismatch.extra += last.extra;
  state.counters["missing"] = static_cast<double>(mismatch.missing);
  state.counters["extra"] = static_cast<double>(mismatch.extra);
  state.SetLabel(mismatch.none() ? hash_text(pair_set_hash(run.pairs()))
                                 : "NOT EXACT: " + describe(mismatch));
}

std::size_t most_bodies_in(std::string_view scene, const PeerInfo& peer) {
  return scene == "wall" ? std::min(peer.most_bodies, peer.most_in_wall) : peer.most_bodies;
}

void register_row(const PeerInfo& peer, const PeerSetting& setting) {
  const std::string name = "peers/" + std::string(peer.name) + "/" + setting.scene + "/" +
                           std::to_string(setting.bodies) + "/" + std::string(info_of(setting.mode).name);
  benchmark::RegisterBenchmark(name.c_str(),
                               [&peer, setting](benchmark::State& state) { run_row(state, peer, setting); })
      ->UseManualTime()
      ->Iterations(1)
      ->Unit(benchmark::kMicrosecond);
}

}  // namespace

void register_peer_suite() {
  for (const PeerInfo& peer : peer_table()) {
    for (const std::string_view scene : kPeerScenes) {
      for (const std::size_t bodies : kPeerBodies) {
        for (const PeerModeInfo& mode : kPeerModes) {
          if (bodies > most_bodies_in(scene, peer)) continue;
          if (mode.mode == PeerMode::static_told && !peer.remembers) continue;
          register_row(peer, {std::string(scene), bodies, mode.mode});
        }
      }
    }
  }
}

}  // namespace cellsweep::bench
