// One rank of a job gets no memory, wherever it asks for some: all ranks are refused and told which, none
// waits, nothing has changed, and the same call again goes on as one engine does.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "cellsweep/query.h"
#include "ranks/starved_rank.h"
#include "ranks/twins.h"

namespace cellsweep::ranks {
namespace {

constexpr BodyId kBodies = 48;

class Numbers {
 public:
  explicit Numbers(std::uint32_t seed) : random_(seed) {}

  int below(int end) { return std::uniform_int_distribution<int>(0, end - 1)(random_); }
  Aabb box() {
    Aabb box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = static_cast<float>(below(17) - 8);
      box.max[axis] = box.min[axis] + static_cast<float>(1 + below(3));
    }
    return box;
  }
  std::vector<Aabb> boxes(std::size_t count) {
    std::vector<Aabb> boxes;
    while (boxes.size() < count) boxes.push_back(box());
    return boxes;
  }

 private:
  std::mt19937 random_;
};

std::vector<BodyId> range(BodyId first, BodyId last) {
  std::vector<BodyId> ids;
  for (BodyId id = first; id < last; ++id) ids.push_back(id);
  return ids;
}

std::vector<GlobalId> global(std::span<const BodyId> ids) {
  std::vector<GlobalId> named;
  for (const BodyId id : ids) named.push_back(global_id(id));
  return named;
}

/// A world of all ranks beside one engine, which is told of a call once the job has been.
class StarvedJob {
 public:
  explicit StarvedJob(StarvedRank& starved) : starved_(starved), twins_({.recut_every = 2}) {}

  void insert(int giver, const std::vector<BodyId>& ids, const std::vector<Aabb>& boxes,
              const std::vector<BodyFilter>& filters = {}) {
    tell(giver, [&, names = global(ids)] { return twins_.world().insert(names, boxes, filters); });
    later_.push_back([=, this] { return twins_.whole().insert(ids, boxes, filters); });
  }
  void move(int giver, const std::vector<BodyId>& ids, const std::vector<Aabb>& boxes) {
    tell(giver, [&, names = global(ids)] { return twins_.world().move(names, boxes); });
    later_.push_back([=, this] { return twins_.whole().move(ids, boxes); });
  }
  void set_filters(int giver, const std::vector<BodyId>& ids, const std::vector<BodyFilter>& filters) {
    tell(giver, [&, names = global(ids)] { return twins_.world().set_filters(names, filters); });
    later_.push_back([=, this] { return twins_.whole().set_filters(ids, filters); });
  }
  void remove(int giver, const std::vector<BodyId>& ids) {
    tell(giver, [&, names = global(ids)] { return twins_.world().remove(names); });
    later_.push_back([=, this] { return twins_.whole().remove(ids); });
  }

  void update() {
    std::optional<RankChanges> said;
    call_all("update", [&] {
      auto changes = twins_.world().update();
      contract::count_calls(false);
      if (changes) said = *changes;
      return changes.status();
    });
    if (!on_all_ranks(said.has_value())) return;
    gather_unlisted();
    for (const auto& call : later_) EXPECT_TRUE(call().ok());
    later_.clear();
    const auto truth = twins_.whole().update();
    ASSERT_TRUE(truth.ok());
    EXPECT_EQ(twins_.compare(*truth, *said), "");
  }

  /// Before anybody has asked for pairs, which are only listed then.
  void gather_unlisted() {
    const std::vector<GlobalId> ids = twins_.world().owned();
    const auto gather = [&] {
      const auto gathered = twins_.world().gather_pairs();
      contract::count_calls(false);
      return gathered.status();
    };
    starved_.call_all("gather_pairs", gather, [&] { return twins_.world().owned() == ids; });
  }

  void gather() {
    std::optional<std::vector<GlobalPair>> all;
    call_all("gather_pairs", [&] {
      auto gathered = twins_.world().gather_pairs(all_ranks() - 1);
      contract::count_calls(false);
      if (gathered) all = std::move(*gathered);
      return gathered.status();
    });
    if (own_rank() != all_ranks() - 1 || !all) return;
    std::vector<GlobalPair> truth;
    for (const auto& [a, b] : twins_.whole().pairs()) truth.push_back({global_id(a), global_id(b)});
    EXPECT_EQ(*all, truth);
  }

  void look_at_own() {
    if (!starved_.is_here()) return;
    std::vector<GlobalId> ids;
    starved_.call([&] {
      ids = twins_.world().owned();
      return Status();
    });
    std::vector<Aabb> boxes(ids.size());
    std::vector<BodyFilter> filters(ids.size());
    starved_.call([&] { return twins_.world().boxes(ids, boxes); });
    starved_.call([&] { return twins_.world().filters(ids, filters); });
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const BodyId id = small_id(ids[i]);
      Aabb box;
      EXPECT_TRUE(twins_.whole().boxes({&id, 1}, {&box, 1}).ok());
      EXPECT_EQ(boxes[i], box);
      EXPECT_EQ(filters[i], twins_.whole().filter(id).value());
    }
    starved_.call([&] {
      static_cast<void>(twins_.world().pairs());
      return Status();
    });
  }

  void ask(Numbers& numbers);

 private:
  /// What this rank has as of the last update, which was compared with one engine.
  struct Own {
    std::vector<GlobalPair> pairs;
    std::vector<GlobalId> ids;
    std::vector<Aabb> boxes;
    std::uint64_t all = 0;

    friend bool operator==(const Own&, const Own&) = default;
  };
  Own own() {
    const DistributedBroadphase& world = twins_.world();
    const auto pairs = world.pairs();
    Own own{{pairs.begin(), pairs.end()}, world.owned(), {}, world.size()};
    own.boxes.resize(own.ids.size());
    EXPECT_TRUE(world.boxes(own.ids, own.boxes).ok());
    return own;
  }

  template <class Call>
  void tell(int giver, const Call& call) {
    if (own_rank() != giver) return;
    if (starved_.is_here()) return starved_.call(call);
    EXPECT_TRUE(call().ok());
  }

  template <class Call>
  void call_all(const char* name, const Call& call) {
    const Own before = own();
    starved_.call_all(name, call, [&] { return own() == before; });
  }

  /// `ask(found)` is collective, `truth[i]` the answers to question i.
  template <class Answer, class One, class Ask, class Same>
  void ask(const char* name, const BatchAnswers<One>& truth, const Ask& ask, const Same& same) {
    BatchAnswers<Answer> found;
    call_all(name, [&] { return ask(found); });
    ASSERT_EQ(found.size(), truth.size()) << name;
    for (std::size_t i = 0; i < truth.size(); ++i)
      EXPECT_TRUE(std::ranges::equal(found[i], truth[i], same)) << name << ", question " << i;
  }

  StarvedRank& starved_;
  Twins twins_;
  std::vector<std::function<Status()>> later_;
};

void StarvedJob::ask(Numbers& numbers) {
  const DistributedQueries all = twins_.world().queries();
  const Queries whole = twins_.whole().queries();
  std::vector<Region> regions;
  std::vector<Path> paths;
  std::vector<Aabb> boxes;
  for (int i = 0; i < 5; ++i) {
    boxes.push_back(numbers.box());
    regions.emplace_back(boxes.back(), numbers.below(4));
    paths.emplace_back(MovingBox{boxes.back(), {1, 0.5, -1}, 6});
  }
  const auto same_body = [](GlobalId id, BodyId body) { return id == global_id(body); };
  const auto same_touch = [](const GlobalTouch& one, const Touch& other) {
    return one.body == global_id(other.body) && one.time == other.time;
  };
  const auto same_neighbor = [](const GlobalNeighbor& one, const Neighbor& other) {
    return one.body == global_id(other.body) && one.distance == other.distance;
  };
  BatchAnswers<BodyId> overlaps;
  BatchAnswers<Touch> touches;
  BatchAnswers<Neighbor> near;
  ASSERT_TRUE(whole.find_overlaps(regions, overlaps).ok());
  ask<GlobalId>(
      "find_overlaps", overlaps, [&](auto& found) { return all.find_overlaps(regions, found); }, same_body);
  ASSERT_TRUE(whole.find_touches(paths, touches).ok());
  ask<GlobalTouch>(
      "find_touches", touches, [&](auto& found) { return all.find_touches(paths, found); }, same_touch);
  ASSERT_TRUE(whole.find_within(regions, near).ok());
  ask<GlobalNeighbor>(
      "find_within", near, [&](auto& found) { return all.find_within(regions, found); }, same_neighbor);
  ASSERT_TRUE(whole.find_nearest(boxes, 3, near).ok());
  ask<GlobalNeighbor>(
      "find_nearest", near, [&](auto& found) { return all.find_nearest(boxes, 3, found); }, same_neighbor);
  std::vector<std::optional<GlobalTouch>> first(paths.size());
  call_all("first_touches", [&] { return all.first_touches(paths, first); });
  for (std::size_t i = 0; i < paths.size(); ++i) {
    ASSERT_EQ(first[i].has_value(), !touches[i].empty());
    EXPECT_TRUE(!first[i] || same_touch(*first[i], touches[i].front()));
  }
}

// Ranks move, filter and remove their own bodies and others', insert some again, and send all across the
// cuts.
void live(StarvedJob& job) {
  Numbers numbers(11);
  const int last = all_ranks() - 1;
  const BodyId half = kBodies / 2;
  job.insert(0, range(0, half), numbers.boxes(half));
  job.insert(last, range(half, kBodies), numbers.boxes(half),
             std::vector<BodyFilter>(half, BodyFilter{.category = 3}));
  job.update();
  job.ask(numbers);
  job.gather();
  job.look_at_own();
  // Own ones and others', by both.
  job.move(0, range(0, half + 6), numbers.boxes(half + 6));
  job.move(last, range(half + 6, kBodies), numbers.boxes(half - 6));
  job.update();
  job.set_filters(last, range(0, 5), std::vector<BodyFilter>(5, BodyFilter{.mask = 2}));
  job.remove(0, range(half, half + 8));
  job.update();
  job.insert(last, range(half, half + 4), numbers.boxes(4));
  job.remove(0, range(8, 12));
  job.insert(0, range(8, 12), numbers.boxes(4));
  job.move(last, range(12, 20), numbers.boxes(8));
  job.update();
  job.ask(numbers);
  job.gather();
  job.look_at_own();
}

TEST(RanksWithoutMemory, AreRefusedTogetherAndGoOnWhenTheCallsAreMadeAgain) {
  const std::uint64_t failures = for_each_starved_rank([](StarvedRank& starved) {
    StarvedJob job(starved);
    live(job);
  });
  EXPECT_GT(failures, 2000U) << "memory is asked for in fewer places than there are";
}

TEST(RanksWithoutMemory, MakeAWorldTogetherOrNone) {
  const std::uint64_t failures = for_each_starved_rank([](StarvedRank& starved) {
    std::optional<DistributedBroadphase> world;
    starved.call_all(
        "make_distributed_broadphase",
        [&] {
          auto made = make_distributed_broadphase(MPI_COMM_WORLD);
          contract::count_calls(false);
          if (made) world.emplace(std::move(*made));
          return made.status();
        },
        [&] { return !world; });
    ASSERT_TRUE(on_all_ranks(world.has_value()));
    EXPECT_TRUE(world->update().ok());
  });
  EXPECT_GT(failures, 40U);
}

}  // namespace
}  // namespace cellsweep::ranks
