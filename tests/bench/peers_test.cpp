#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "bench/peers/peer_check.h"
#include "bench/peers/peer_run.h"
#include "bench/peers/peer_table.h"
#include "contract/effort.h"
#include "world/scene_probe.h"

namespace cellsweep::bench {
namespace {

TEST(Peers, HaveNamesOfTheirOwnThatFitIntoARowsName) {
  std::set<std::string_view> names;
  for (const PeerInfo& peer : peer_table()) {
    EXPECT_TRUE(names.insert(peer.name).second) << peer.name;
    EXPECT_EQ(peer.name.find('/'), std::string_view::npos) << peer.name;
    EXPECT_FALSE(peer.threads.empty() || peer.margin.empty() || peer.settings.empty()) << peer.name;
  }
  EXPECT_TRUE(names.contains("stream"));
  EXPECT_TRUE(names.contains("box_pruning"));
}

TEST(Peers, FindExactlyThePairsInEverySceneAndMode) {
  const std::size_t bodies = contract::effort(300, 60, 60);
  const std::size_t frames = contract::effort(4, 2, 2);
  for (const PeerInfo& peer : peer_table()) {
    if (!peer.finds_pairs) continue;
    for (std::size_t scene = 0; scene < kPeerScenes.size(); ++scene) {
      const std::string name(kPeerScenes[scene]);
      for (const PeerModeInfo& mode : kPeerModes) {
        if (!has_rows(peer, scene, mode.mode)) continue;
        const Mismatch mismatch = check_peer(peer, {name, bodies, mode.mode}, frames);
        EXPECT_TRUE(mismatch.none()) << peer.name << ", " << name << ", " << mode.name << ": "
                                     << describe(mismatch);
      }
    }
  }
}

PeerInfo peer_of(std::string_view name) {
  return *std::find_if(peer_table().begin(), peer_table().end(),
                       [&](const PeerInfo& peer) { return peer.name == name; });
}

std::size_t place_of(std::string_view scene) {
  return static_cast<std::size_t>(std::find(kPeerScenes.begin(), kPeerScenes.end(), scene) -
                                  kPeerScenes.begin());
}

TEST(PeerRun, CountsTheWorkOfEachFrameOfEnginesThatCount) {
  const PeerInfo stream = peer_of("stream_1");
  PeerRun all_new(stream, {"uniform", 500, PeerMode::initial});
  for (int frame = 0; frame < 3; ++frame) {
    all_new.next_frame();
    EXPECT_EQ(all_new.work().boxes_placed, 500U) << "each frame has a broadphase of its own";
    EXPECT_GE(all_new.work().boxes_compared, all_new.listed().size());
  }
  PeerRun still(stream, {"uniform", 500, PeerMode::static_told});
  still.next_frame();
  EXPECT_EQ(still.work().boxes_placed + still.work().boxes_compared, 0U);
  PeerRun moving(stream, {"uniform", 500, PeerMode::dyn100});
  for (int frame = 0; frame < 3; ++frame) moving.next_frame();
  EXPECT_GT(moving.work().boxes_compared, 0U);
  const PeerInfo box_pruning = peer_of("box_pruning");
  PeerRun other(box_pruning, {"uniform", 500, PeerMode::initial});
  other.next_frame();
  EXPECT_EQ(other.work().boxes_compared, 0U) << "it does not count";
}

/// Leaves out one pair and lists another twice.
class WrongPeer final : public Peer {
 public:
  void insert(std::span<const Aabb> boxes) override { boxes_ = boxes; }
  void update(std::span<const Aabb>, const PeerChanges&) override {}
  void list_pairs(std::vector<Pair>& pairs) override {
    pairs.clear();
    for (BodyId a = 0; a < boxes_.size(); ++a) {
      for (BodyId b = a + 1; b < boxes_.size(); ++b) {
        if (overlap(boxes_[a], boxes_[b])) pairs.push_back({b, a});
      }
    }
    pairs.front() = pairs.back();
  }

 private:
  std::span<const Aabb> boxes_;
};

TEST(PeerCheck, CountsWhatIsMissingAndWhatIsListedTwice) {
  PeerInfo info;
  info.make = [] { return std::make_unique<WrongPeer>(); };
  const Mismatch mismatch = check_peer(info, {"uniform", 100, PeerMode::initial}, 3);
  EXPECT_EQ(mismatch.missing, 3U);
  EXPECT_EQ(mismatch.extra, 3U);
  EXPECT_EQ(describe(mismatch), "3 pairs missing, 3 too many");
}

TEST(Peers, MayHaveIdsOfTheirOwnThatStandForTheSameBodies) {
  const PeerSetting setting{"clustered", 200, PeerMode::dyn100};
  const PeerInfo dense_info = peer_of("stream");
  const PeerInfo scattered_info = peer_of("stream_scattered");
  PeerRun dense(dense_info, setting);
  PeerRun scattered(scattered_info, setting);
  for (int frame = 0; frame < 3; ++frame) {
    dense.next_frame();
    scattered.next_frame();
    std::vector<Pair> pairs = scattered.pairs();
    std::sort(pairs.begin(), pairs.end());
    EXPECT_EQ(pairs, dense.pairs());
    EXPECT_NE(scattered.listed(), dense.listed());
  }
}

TEST(PeerCheck, SumsUpTheOraclesPairsOfEachFrame) {
  const PeerInfo info = peer_of("stream");
  const PeerSetting setting{"uniform", 300, PeerMode::dyn100};
  PeerRun run(info, setting);
  std::set<std::uint64_t> hashes;
  for (int frame = 0; frame < 3; ++frame) {
    run.next_frame();
    const PairSum sum = oracle_sum(setting, run);
    EXPECT_EQ(sum, (PairSum{run.pairs().size(), pair_set_hash(run.pairs())}));
    EXPECT_EQ(sum, oracle_sum(setting, run));
    hashes.insert(sum.hash);
  }
  EXPECT_EQ(hashes.size(), 3U);
}

TEST(Peers, AreExactWithAGiantInEachPlace) {
  for (const PeerInfo& peer : peer_table()) {
    if (!peer.finds_pairs) continue;
    for (const GiantSlot giant : {GiantSlot::first, GiantSlot::middle, GiantSlot::last}) {
      for (const std::string scene : {"uniform", "pile", "open-world"}) {
        const PeerMode mode = scene == "uniform" ? PeerMode::dyn10 : PeerMode::own;
        if (!has_rows(peer, place_of(scene), mode)) continue;
        const Mismatch mismatch = check_peer(peer, {scene, 100, mode, giant}, 3);
        EXPECT_TRUE(mismatch.none()) << peer.name << ", " << scene << ": " << describe(mismatch);
      }
    }
  }
}

TEST(Peers, AreExactWhereBodiesComeAndGo) {
  for (const PeerInfo& peer : peer_table()) {
    if (!peer.finds_pairs || !has_rows(peer, place_of("open-world"), PeerMode::own)) continue;
    const Mismatch mismatch = check_peer(peer, {"open-world", 200, PeerMode::own}, 40);
    EXPECT_TRUE(mismatch.none()) << peer.name << ": " << describe(mismatch);
  }
}

TEST(PeerRun, GoesThroughManyWorldsWhenAllBodiesAreNew) {
  const PeerInfo info = peer_of("stream");
  PeerRun run(info, {"uniform", 50, PeerMode::initial});
  std::set<std::uint64_t> hashes;
  for (std::size_t frame = 0; frame < 2 * kManyWorlds; ++frame) {
    run.next_frame();
    EXPECT_EQ(run.key().seed, frame % kManyWorlds + 1);
    hashes.insert(test::bits_hash(run.boxes()));
  }
  EXPECT_EQ(hashes.size(), kManyWorlds);
}

TEST(PeerRun, MovesAsManyBodiesAsTheModeSays) {
  PeerInfo info = peer_table().front();
  const PeerSetting setting{"uniform", 200, PeerMode::dyn10};
  PeerRun run(info, setting);
  const std::vector<Aabb> before(run.boxes().begin(), run.boxes().end());
  EXPECT_GE(run.next_frame(), 0);
  std::size_t moved = 0;
  for (std::size_t i = 0; i < before.size(); ++i) moved += before[i] == run.boxes()[i] ? 0 : 1;
  EXPECT_EQ(moved, 20U);
}

}  // namespace
}  // namespace cellsweep::bench
