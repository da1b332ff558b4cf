#include "bench/peers/few_suite.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"
#include "bench/peers/grid_oracle.h"
#include "bench/peers/peer_mode.h"
#include "bench/peers/peer_table.h"
#include "bench/peers/timed_frame.h"
#include "bench/timed_row.h"
#include "cellsweep/world/frame_source.h"
#include "cellsweep/world/scene.h"
#include "report/quantile.h"
#include "world/random.h"

namespace cellsweep::bench {
namespace {

constexpr std::array<std::string_view, 3> kPeers = {"stream_1", "bullet_dbvt", "bullet_dbvt_margin0"};
constexpr std::array<std::string_view, 2> kScenes = {"uniform", "clustered"};
constexpr std::array<std::size_t, 3> kMovers = {1, 10, 100};

/// A world that was entered as a whole comes to rest: fat boxes, memory given back.
constexpr std::size_t kFramesBefore = 100;
constexpr std::size_t kMostFrames = 6'000;
constexpr double kMostSeconds = 2;

struct FewSetting {
  std::string scene;
  std::size_t bodies = 0;
  std::size_t movers = 0;
};

SceneSettings scene_of(const FewSetting& setting) {
  SceneSettings scene;
  scene.scene = setting.scene;
  scene.bodies = setting.bodies;
  return scene;
}

/// A world of which a few bodies, others each time, are shifted by a tenth of their size at most.
class FewMovers {
 public:
  explicit FewMovers(const FewSetting& setting) : movers_(setting.movers), random_(1) {
    const auto source = std::move(*make_scene_frames(scene_of(setting)));
    boxes_.assign(source->boxes().begin(), source->boxes().end());
  }

  void advance() {
    moved_.clear();
    while (moved_.size() < movers_) {
      const auto id = static_cast<BodyId>(random_.below(boxes_.size()));
      if (std::find(moved_.begin(), moved_.end(), id) == moved_.end()) moved_.push_back(id);
    }
    for (const BodyId id : moved_) shift(boxes_[id]);
  }

  std::span<const Aabb> boxes() const { return boxes_; }
  std::span<const BodyId> moved() const { return moved_; }

 private:
  void shift(Aabb& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto by = static_cast<float>(random_.between(-0.1, 0.1)) * (box.max[axis] - box.min[axis]);
      box.min[axis] += by;
      box.max[axis] += by;
    }
  }

  std::size_t movers_;
  Random random_;
  std::vector<Aabb> boxes_;
  std::vector<BodyId> moved_;
};

double seconds_of_frame(Peer& peer, FewMovers& world) {
  using Clock = std::chrono::steady_clock;
  world.advance();
  const Clock::time_point start = Clock::now();
  peer.update(world.boxes(), {world.moved()});
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::vector<double> time_frames(Peer& peer, FewMovers& world) {
  std::vector<double> undisturbed;
  double sum = 0;
  for (std::size_t i = 0; i < kMostFrames && sum < kMostSeconds; ++i) {
    const TimedFrame frame = time_frame([&] { return seconds_of_frame(peer, world); });
    sum += frame.seconds;
    if (frame.is_undisturbed) undisturbed.push_back(frame.seconds);
  }
  return undisturbed;
}

std::uint64_t hash_of(std::vector<Pair> pairs) {
  for (Pair& pair : pairs) pair = make_pair_of(pair.a, pair.b);
  return pair_set_hash(pairs);
}

void run_row(benchmark::State& state, const PeerInfo& info, const FewSetting& setting) {
  FewMovers world(setting);
  const std::unique_ptr<Peer> peer = info.make();
  peer->prepare({*scene_bounds(scene_of(setting)), world.boxes()});
  peer->insert(world.boxes());
  std::vector<double> seconds;
  for (auto _ : state) {
    for (std::size_t i = 0; i < kFramesBefore; ++i) seconds_of_frame(*peer, world);
    seconds = time_frames(*peer, world);
    if (seconds.empty()) return state.SkipWithError("no frame without an involuntary switch");
    state.SetIterationTime(std::accumulate(seconds.begin(), seconds.end(), 0.0) /
                           static_cast<double>(seconds.size()));
  }
  state.counters["median"] = 1e6 * report::quantile(seconds, 0.5);
  state.counters["p99"] = 1e6 * report::quantile(seconds, 0.99);
  state.counters["slowest"] = 1e6 * report::quantile(seconds, 1.0);
  state.counters["frames"] = static_cast<double>(seconds.size());
  std::vector<Pair> pairs;
  peer->list_pairs(pairs);
  state.counters["pairs"] = static_cast<double>(pairs.size());
  const std::uint64_t hash = hash_of(pairs);
  const bool is_exact = hash == hash_of(grid_pairs(world.boxes()));
  state.SetLabel(is_exact ? hash_text(hash) : "NOT EXACT: " + hash_text(hash));
}

void register_row(const PeerInfo& info, const FewSetting& setting) {
  const std::string name =
      text("few/", info.name, "/", setting.scene, "/", setting.bodies, "/", setting.movers);
  register_timed_row(name, [&info, setting](benchmark::State& state) { run_row(state, info, setting); });
}

void register_in_turn(const FewSetting& setting) {
  for (std::size_t turn = 0; turn < turns_with(setting.bodies); ++turn) {
    for (const PeerInfo& info : peer_table()) {
      if (std::find(kPeers.begin(), kPeers.end(), info.name) != kPeers.end()) register_row(info, setting);
    }
  }
}

}  // namespace

void register_few_suite() {
  for (const std::string_view scene : kScenes) {
    for (const std::size_t bodies : kPeerBodies) {
      if (bodies < 10'000) continue;  // there a hundred are not few
      for (const std::size_t movers : kMovers) register_in_turn({std::string(scene), bodies, movers});
    }
  }
}

}  // namespace cellsweep::bench
