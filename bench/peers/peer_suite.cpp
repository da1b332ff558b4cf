#include "bench/peers/peer_suite.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bench/peers/peer_check.h"
#include "bench/peers/peer_table.h"
#include "bench/timed_row.h"
#include "report/quantile.h"

namespace cellsweep::bench {
namespace {

constexpr std::size_t kBodiesToCheck = 1'000;
constexpr std::size_t kFramesToCheck = 8;
constexpr std::size_t kFramesToCheckOfOwn = 24;  // in fewer of scene open-world nobody comes

// Once for each peer, scene and mode, whatever the repetitions.
Mismatch check_once(const PeerInfo& peer, const PeerSetting& setting) {
  static std::map<std::tuple<std::string, std::string, PeerMode>, Mismatch> known;
  const auto [entry, is_new] = known.try_emplace({std::string(peer.name), setting.scene, setting.mode});
  if (is_new) {
    PeerSetting small = setting;
    small.bodies = kBodiesToCheck;
    entry->second =
        check_peer(peer, small, setting.mode == PeerMode::own ? kFramesToCheckOfOwn : kFramesToCheck);
  }
  return entry->second;
}

// The list is sorted and compared only when count or hash differ.
Mismatch check_last_frame(const PeerRun& run, const PeerSetting& setting) {
  const std::vector<Pair> pairs = run.pairs();
  if (oracle_sum(setting, run) == PairSum{pairs.size(), pair_set_hash(pairs)}) return {};
  return compare_with_oracle(run);
}

// In scene open-world bodies go for 8 frames and come for 8.
std::size_t fewest_frames(const PeerSetting& setting) {
  return setting.scene == "open-world" && setting.mode == PeerMode::own ? 16 : 3;
}

double mean_of(const std::vector<double>& numbers) {
  return std::accumulate(numbers.begin(), numbers.end(), 0.0) / static_cast<double>(numbers.size());
}

/// Of the frames of a row.
struct TimedFrames {
  std::vector<double> seconds;
  Work work;

  void add(double seconds_of_frame, const Work& work_of_frame) {
    seconds.push_back(seconds_of_frame);
    work.boxes_placed += work_of_frame.boxes_placed;
    work.boxes_compared += work_of_frame.boxes_compared;
  }
};

// Slow peers need not take as many frames.
TimedFrames time_frames(PeerRun& run, const PeerSetting& setting) {
  constexpr double kLongEnough = 0.4;  // seconds
  const std::size_t fewest = fewest_frames(setting);
  // An engine that keeps something from frame to frame first learns that bodies move; and the first frame
  // waits until the operating system has cleared memory for it.
  const std::size_t frames_before = info_of(setting.mode).moving.value_or(1) > 0 ? 2 : 1;
  for (std::size_t i = 0; i < frames_before; ++i) run.next_frame();
  TimedFrames frames;
  double sum = 0;
  while (frames.seconds.size() < frames_of(setting) &&
         (sum < kLongEnough || frames.seconds.size() < fewest)) {
    const double seconds = run.next_frame();
    frames.add(seconds, run.work());
    sum += seconds;
  }
  return frames;
}

// The means of frames, of peers that count.
void show_work(benchmark::State& state, const TimedFrames& frames) {
  const auto count = static_cast<double>(frames.seconds.size());
  if (frames.work.boxes_compared == 0 && frames.work.boxes_placed == 0) return;
  state.counters["placed"] = static_cast<double>(frames.work.boxes_placed) / count;
  state.counters["compared"] = static_cast<double>(frames.work.boxes_compared) / count;
}

void run_row(benchmark::State& state, const PeerInfo& peer, const PeerSetting& setting) {
  Mismatch mismatch;
  if (peer.finds_pairs) mismatch = check_once(peer, setting);
  PeerRun run(peer, setting);
  TimedFrames frames;
  for (auto _ : state) {
    frames = time_frames(run, setting);
    state.SetIterationTime(mean_of(frames.seconds));
  }
  const std::vector<double>& seconds = frames.seconds;
  show_work(state, frames);
  state.counters["pairs"] = static_cast<double>(run.listed().size());
  state.counters["frames"] = static_cast<double>(seconds.size());
  state.counters["median"] = 1e6 * report::quantile(seconds, 0.5);
  state.counters["p99"] = 1e6 * report::quantile(seconds, 0.99);
  state.counters["slowest"] = 1e6 * report::quantile(seconds, 1.0);
  if (!peer.finds_pairs) return;
  const Mismatch last = check_last_frame(run, setting);
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
  register_timed_row(name, [&peer, setting](benchmark::State& state) { run_row(state, peer, setting); });
}

bool takes_part(const PeerInfo& peer, std::size_t scene, const PeerSetting& setting) {
  return setting.bodies <= most_bodies_in(setting.scene, peer) && has_rows(peer, scene, setting.mode);
}

// Peers that are compared are measured within seconds: a machine that others share takes half as long again
// for minutes at a time.
void register_cell(std::size_t scene, const PeerSetting& setting) {
  for (std::size_t turn = 0; turn < turns_with(setting.bodies); ++turn) {
    for (const PeerInfo& peer : peer_table()) {
      if (takes_part(peer, scene, setting)) register_row(peer, setting);
    }
  }
}

}  // namespace

void register_peer_suite(GiantSlot giant) {
  for (std::size_t scene = 0; scene < kPeerScenes.size(); ++scene) {
    for (const std::size_t bodies : kPeerBodies) {
      for (const PeerModeInfo& mode : kPeerModes) {
        register_cell(scene, {std::string(kPeerScenes[scene]), bodies, mode.mode, giant});
      }
    }
  }
}

}  // namespace cellsweep::bench
