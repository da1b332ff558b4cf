// Random calls of all ranks, with boxes that meet cuts, corners and each other, against one engine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <random>
#include <set>

#include "cellsweep/engine/engine.h"
#include "ranks/twins.h"

namespace cellsweep::ranks {
namespace {

bool engine_fails = false;  // on this rank

/// All against all, or nothing where this rank's engine is to fail.
class FailingEngine : public Engine {
 public:
  Capacity capacity() const override { return {1000, "", "a test"}; }

  Result<FoundPairs> update(const BodyChanges& changes, Statistics&) override {
    if (engine_fails) return Status::spe_failed("it was told to fail");
    found_.clear();
    for (Slot a = 0; a < changes.boxes.size(); ++a) {
      for (Slot b = a + 1; b < changes.boxes.size(); ++b) {
        if (overlap(changes.boxes[a], changes.boxes[b])) found_.push_back({a, b});
      }
    }
    return FoundPairs{.began = found_, .is_whole_set = true};
  }

 private:
  std::vector<SlotPair> found_;
};

Result<Broadphase> make_failing() {
  return EngineAccess::make(
      "failing", [] { return Result<std::unique_ptr<Engine>>(std::make_unique<FailingEngine>()); });
}

/// Calls as a program might make them; every rank makes the same choices.
class RandomCaller {
 public:
  RandomCaller(std::uint32_t seed, const RankOptions& options) : random_(seed), twins_(options) {
    apart = seed % 2 == 0 ? 1 : kFarApart;
  }
  ~RandomCaller() { apart = kFarApart; }
  RandomCaller(const RandomCaller&) = delete;
  RandomCaller& operator=(const RandomCaller&) = delete;

  /// Before the update that counts there are some that one rank's engine refuses, and calls between them.
  std::string frame(std::size_t most_failures = 0) {
    for (std::size_t failures = most_failures == 0 ? 0 : below(most_failures + 1); failures > 0; --failures) {
      make_calls();
      engine_fails = own_rank() == static_cast<int>(below(static_cast<std::size_t>(all_ranks())));
      const std::string refusal = twins_.world().update().status().message;
      engine_fails = false;
      if (!refusal.ends_with("it was told to fail")) return "refused otherwise: " + refusal;
      if (const std::string words = twins_.compare_pairs(); !words.empty())
        return "after a failure: " + words;
    }
    make_calls();
    return twins_.update_and_compare();
  }

 private:
  std::size_t below(std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
  }

  // A grid of few places, so that boxes touch, are points, and lie on cuts.
  Aabb box() {
    Aabb box;
    const bool giant = below(40) == 0;
    const bool crowded = below(3) == 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto low = static_cast<float>(crowded ? below(3) : below(24)) - 12;
      box.min[axis] = giant ? low - 30 : low;
      box.max[axis] = giant ? low + 30 : low + static_cast<float>(below(3));
    }
    return box;
  }
  BodyFilter filter() { return {1U << below(3), below(2) == 0 ? 0xffffffffU : 3U, below(6) == 0}; }

  // Bodies that no other rank has named since the last update; those that are there, or not.
  std::vector<BodyId> choose(int giver, bool present, std::size_t most) {
    std::vector<BodyId> ids;
    for (std::size_t i = 0; i < most; ++i) {
      const auto id = static_cast<BodyId>(below(120));
      if (there_.contains(id) != present || std::ranges::find(ids, id) != ids.end()) continue;
      const auto [named, is_first] = named_.try_emplace(id, giver);
      if (named->second == giver) ids.push_back(id);
    }
    return ids;
  }

  void make_calls() {
    named_.clear();
    const int calls = 1 + static_cast<int>(below(6));
    for (int call = 0; call < calls; ++call) make_call();
  }

  void make_call() {
    const auto giver = static_cast<int>(below(static_cast<std::size_t>(all_ranks())));
    const std::size_t kind = below(10);
    const std::vector<BodyId> ids = choose(giver, kind >= 3, 1 + below(30));
    std::vector<Aabb> boxes;
    std::vector<BodyFilter> filters;
    for (std::size_t i = 0; i < ids.size(); ++i) {
      boxes.push_back(box());
      filters.push_back(filter());
    }
    if (kind < 3) {
      if (kind == 0) filters.clear();
      twins_.insert(giver, ids, boxes, filters);
      there_.insert(ids.begin(), ids.end());
    } else if (kind == 3) {
      twins_.remove(giver, ids);
      for (const BodyId id : ids) there_.erase(id);
    } else if (kind == 4) {
      twins_.set_filters(giver, ids, filters);
    } else {
      twins_.move(giver, ids, boxes);
    }
  }

  std::mt19937 random_;
  Twins twins_;
  std::set<BodyId> there_;
  std::map<BodyId, int> named_;
};

// So many worlds a test, and many more in the long form.
std::uint32_t worlds() {
  return std::getenv("CELLSWEEP_LONG_TESTS") != nullptr ? 1000 : 30;
}

TEST(RandomCalls, OfAllRanksGiveWhatOneEngineGives) {
  for (std::uint32_t seed = 1; seed <= worlds(); ++seed) {
    RandomCaller caller(seed, {.recut_above = seed % 3 == 0 ? 100.0 : 1.1, .recut_every = seed % 4});
    for (int frame = 0; frame < 25; ++frame)
      ASSERT_EQ(caller.frame(), "") << "seed " << seed << ", frame " << frame;
  }
}

TEST(RandomCalls, AreNotLostByUpdatesThatFail) {
  for (std::uint32_t seed = 1; seed <= worlds(); ++seed) {
    RandomCaller caller(seed, {.make_engine = make_failing, .recut_above = 1.1, .recut_every = seed % 3});
    for (int frame = 0; frame < 20; ++frame)
      ASSERT_EQ(caller.frame(3), "") << "seed " << seed << ", frame " << frame;
  }
}

TEST(Bodies, InOnePlaceBelongToOneRankAndArePairedOnce) {
  Twins twins({.recut_above = 1});
  const std::vector<Aabb> boxes(60, Aabb{{1, 1, 1}, {1, 1, 1}});
  std::vector<BodyId> ids(boxes.size());
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<BodyId>(i);
  twins.insert(all_ranks() - 1, ids, boxes);
  EXPECT_EQ(twins.update_and_compare(), "");
  const std::uint64_t cuts = twins.world().statistics().cuts;
  for (int frame = 0; frame < 5; ++frame) EXPECT_EQ(twins.update_and_compare(), "");
  EXPECT_EQ(twins.world().statistics().cuts, cuts) << "cut again though it cannot be cut better";
}

TEST(Bodies, ThatMeetOnACutAreOneRanksPair) {
  Twins twins;
  // Unit cubes side by side: all cuts go along faces.
  std::vector<Aabb> boxes;
  std::vector<BodyId> ids;
  for (int x = 0; x < 6; ++x) {
    for (int y = 0; y < 6; ++y) {
      for (int z = 0; z < 6; ++z) {
        const Point low{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
        ids.push_back(static_cast<BodyId>(ids.size()));
        boxes.push_back({low, {low[0] + 1, low[1] + 1, low[2] + 1}});
      }
    }
  }
  twins.insert(0, ids, boxes);
  EXPECT_EQ(twins.update_and_compare(), "");
  EXPECT_GT(twins.whole().pairs().size(), 1000U);
}

}  // namespace
}  // namespace cellsweep::ranks
