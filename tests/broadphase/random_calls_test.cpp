/// @file
/// Bodies, the order of pairs and the set of pairs together, through random calls, against plain maps.
#include <gmock/gmock.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "base/threads/numbers_of_workers.h"
#include "base/threads/thread_pool.h"
#include "broadphase/bodies/shown.h"
#include "broadphase/pairs/pair_order.h"
#include "broadphase/pairs/pair_set.h"
#include "cellsweep/broadphase.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using contract::Random;

/// How pairs are handed over.
enum class Way { changes, changes_in_parts, whole_set, failure };

/// An engine that compares all with all and checks what it is told.
class PlainEngine {
 public:
  /// Takes the changes in. What was must be what it knows, and what is must be all that it is told.
  void take(const BodyChanges& changes) {
    boxes_.resize(changes.boxes.size(), kNobody);
    std::set<Slot> changed;
    for (const Slot slot : changes.removed) {
      EXPECT_EQ(bits(boxes_[slot]), bits(changes.before[slot]));
      EXPECT_TRUE(changed.insert(slot).second);
      boxes_[slot] = kNobody;
    }
    for (const Slot slot : changes.moved) {
      EXPECT_EQ(bits(boxes_[slot]), bits(changes.before[slot]));
      EXPECT_TRUE(changed.insert(slot).second);
      boxes_[slot] = changes.boxes[slot];
    }
    for (const Slot slot : changes.inserted) {
      EXPECT_EQ(bits(boxes_[slot]), bits(kNobody));
      EXPECT_TRUE(changed.insert(slot).second);
      boxes_[slot] = changes.boxes[slot];
    }
    std::size_t bodies = 0;
    for (Slot slot = 0; slot < boxes_.size(); ++slot) {
      EXPECT_EQ(bits(boxes_[slot]), bits(changes.boxes[slot])) << "a change was not told";
      bodies += bits(boxes_[slot]) == bits(kNobody) ? 0 : 1;
    }
    EXPECT_EQ(changes.bodies, bodies);
    if (bodies == 0) boxes_.clear();
    const std::set<SlotPair> before = std::exchange(pairs_, compare());
    // The pairs of a body in a slot that was another's are others.
    std::set<SlotPair> kept = before;
    for (const Slot slot : changes.removed)
      std::erase_if(kept, [&](const SlotPair& pair) { return pair.a == slot || pair.b == slot; });
    began_.clear();
    ended_.clear();
    std::ranges::set_difference(pairs_, kept, std::back_inserter(began_));
    std::ranges::set_difference(before, pairs_, std::back_inserter(ended_));
  }

  void forget() { *this = PlainEngine(); }

  const std::vector<SlotPair>& began() const { return began_; }
  const std::vector<SlotPair>& ended() const { return ended_; }
  std::vector<SlotPair> all() const { return {pairs_.begin(), pairs_.end()}; }

 private:
  std::set<SlotPair> compare() const {
    std::set<SlotPair> pairs;
    for (Slot a = 0; a < boxes_.size(); ++a) {
      for (Slot b = a + 1; b < boxes_.size(); ++b) {
        if (overlap(boxes_[a], boxes_[b])) pairs.insert({a, b});
      }
    }
    return pairs;
  }

  std::vector<Aabb> boxes_;
  std::set<SlotPair> pairs_;
  std::vector<SlotPair> began_;
  std::vector<SlotPair> ended_;
};

/// The rooms of a broadphase, put together as it does, and what they should hold.
class Rooms {
 public:
  explicit Rooms(unsigned workers)
      : crew_(std::make_shared<ThreadPool>(workers), workers, Crew::Choice::given) {}

  const std::map<BodyId, Aabb>& held() const { return held_; }

  Status insert(const Ids& ids, const std::vector<Aabb>& boxes) {
    const Status status = bodies_.insert(crew_, ids, boxes, {}, "test", kAnyNumber);
    if (!status.ok()) return status;
    for (std::size_t i = 0; i < ids.size(); ++i) held_[ids[i]] = boxes[i];
    return status;
  }

  Status move(const Ids& ids, const std::vector<Aabb>& boxes) {
    const Status status = bodies_.move(crew_, ids, boxes);
    if (!status.ok()) return status;
    for (std::size_t i = 0; i < ids.size(); ++i) held_.at(ids[i]) = boxes[i];
    return status;
  }

  Status remove(const Ids& ids) {
    const Status status = bodies_.remove(ids);
    if (!status.ok()) return status;
    for (const BodyId id : ids) {
      held_.erase(id);
      gone_.insert(id);
    }
    return status;
  }

  void add(const std::vector<Aabb>& boxes) {
    Ids ids(boxes.size());
    ASSERT_TRUE(bodies_.add(crew_, boxes, ids, "test", kAnyNumber).ok());
    for (std::size_t i = 0; i < ids.size(); ++i) {
      ASSERT_FALSE(gone_.contains(ids[i])) << "its pairs have not ended";
      ASSERT_TRUE(held_.emplace(ids[i], boxes[i]).second);
    }
  }

  void update(Way way) {
    set_.remember_changes();
    BodyChanges changes = bodies_.begin_update();
    if (way == Way::failure) {
      engine_.forget();
      is_lost_ = true;
      return bodies_.undo();
    }
    if (is_lost_) changes = bodies_.all_as_new();
    engine_.take(changes);
    if (is_lost_ || way == Way::whole_set) {
      hand_over_all();
    } else {
      hand_over_changes(way == Way::changes_in_parts);
    }
    bodies_.commit();
    const PairChanges said = set_.next_changes();
    set_.commit();
    expect_changes(said);
    is_lost_ = bodies_.tidy();
    tidied_ += is_lost_ ? 1 : 0;
    if (is_lost_) engine_.forget();
  }

  void expect_right() const {
    EXPECT_EQ(bodies_.size(), held_.size());
    EXPECT_TRUE(std::ranges::equal(set_.pairs(), pairs_));
    for (const auto& [id, box] : shown_) {
      if (gone_.contains(id)) continue;
      ASSERT_EQ(box_of(bodies_, id), bits(box));
    }
  }

  std::size_t bytes() const { return bodies_.bytes(); }
  int tidied() const { return tidied_; }

 private:
  void hand_over_all() {
    order_.name_pairs(crew_, bodies_.table(), engine_.all(), {}, set_.next_began());
    order_.name_pairs(crew_, bodies_.table(), {}, {}, set_.next_ended());
    set_.compare_with_whole_set(bodies_.removed_ids());
  }

  void hand_over_changes(bool in_parts) {
    std::vector<SlotPair> listed = engine_.began();
    std::vector<std::uint64_t> keys;
    while (in_parts && listed.size() > 1 && keys.size() < engine_.began().size() / 2) {
      keys.push_back(pair_key(listed.back()));
      listed.pop_back();
    }
    const std::span<const std::uint64_t> part = keys;
    order_.name_pairs(crew_, bodies_.table(), listed, {&part, 1}, set_.next_began());
    order_.name_pairs(crew_, bodies_.table(), engine_.ended(), {}, set_.next_ended());
  }

  void expect_changes(const PairChanges& changes) {
    std::set<Pair> now;
    for (auto one = held_.begin(); one != held_.end(); ++one) {
      for (auto other = std::next(one); other != held_.end(); ++other) {
        if (overlap(one->second, other->second)) now.insert({one->first, other->first});
      }
    }
    std::vector<Pair> kept;
    std::ranges::set_intersection(pairs_, now, std::back_inserter(kept));
    std::erase_if(kept, [&](const Pair& pair) { return gone_.contains(pair.a) || gone_.contains(pair.b); });
    std::vector<Pair> began;
    std::vector<Pair> ended;
    std::ranges::set_difference(now, kept, std::back_inserter(began));
    std::ranges::set_difference(pairs_, kept, std::back_inserter(ended));
    EXPECT_TRUE(std::ranges::equal(changes.began, began));
    EXPECT_TRUE(std::ranges::equal(changes.ended, ended));
    pairs_ = now;
    shown_ = held_;
    gone_.clear();
  }

  Crew crew_;
  Bodies bodies_;
  PairOrder order_;
  PairSet set_;
  PlainEngine engine_;
  bool is_lost_ = false;
  int tidied_ = 0;
  std::map<BodyId, Aabb> held_;
  std::map<BodyId, Aabb> shown_;  // as of the last update
  std::set<BodyId> gone_;         // since then
  std::set<Pair> pairs_;
};

/// Calls of every kind with ids of one family.
class RandomCalls {
 public:
  RandomCalls(Rooms& rooms, std::uint64_t seed, BodyId factor)
      : rooms_(rooms), random_(seed), factor_(factor) {}

  void call() {
    switch (random_.below(8)) {
      case 0:
      case 1:
        return insert();
      case 2:
        return remove();
      case 3:
        return replace();
      case 4:
        return refused();
      case 5:
        return rooms_.add(boxes(random_.below(4)));
      default:
        return move();
    }
  }

  void update() {
    constexpr Way kWays[] = {Way::changes, Way::changes_in_parts, Way::whole_set, Way::failure};
    rooms_.update(kWays[random_.below(4)]);
  }

  /// Many bodies that overlap nobody come and go.
  void crowd() {
    const Ids ids = ids_from(2'000'000'000, 1400);
    std::vector<Aabb> far;
    for (std::size_t i = 0; i < ids.size(); ++i) far.push_back(box_at(1000 + 2 * static_cast<float>(i)));
    ASSERT_TRUE(rooms_.insert(ids, far).ok());
    rooms_.update(Way::changes);
    ASSERT_TRUE(rooms_.remove(ids).ok());
    rooms_.update(Way::changes);
  }

  void remove_all() { ASSERT_TRUE(rooms_.remove(all()).ok()); }

  Random& random() { return random_; }

 private:
  Aabb box() { return box_at(static_cast<float>(random_.whole(0, 60)) / 2); }
  std::vector<Aabb> boxes(std::size_t count) {
    std::vector<Aabb> made(count);
    for (Aabb& made_box : made) made_box = box();
    return made;
  }

  Ids all() const {
    Ids ids;
    for (const auto& [id, box] : rooms_.held()) ids.push_back(id);
    return ids;
  }

  /// Ids of the family that nobody has.
  Ids fresh(std::size_t count) {
    std::set<BodyId> ids;
    for (std::size_t i = 0; i < count; ++i) {
      const BodyId id = random_.one_in(12) ? 0xffffffffU : static_cast<BodyId>(random_.below(90)) * factor_;
      if (!rooms_.held().contains(id)) ids.insert(id);
    }
    Ids mixed(ids.begin(), ids.end());
    if (random_.one_in(2)) random_.shuffle(mixed);
    return mixed;
  }

  Ids some() {
    Ids ids = all();
    if (random_.one_in(2)) random_.shuffle(ids);
    if (!ids.empty() && !random_.one_in(4)) ids.resize(random_.below(ids.size()));
    return ids;
  }

  void insert() {
    const Ids ids = fresh(random_.below(8));
    ASSERT_TRUE(rooms_.insert(ids, boxes(ids.size())).ok());
  }

  void remove() {
    Ids ids = some();
    if (ids.size() > 5 && !random_.one_in(20)) ids.resize(5);
    ASSERT_TRUE(rooms_.remove(ids).ok());
  }

  void replace() {
    Ids ids = some();
    if (ids.size() > 3) ids.resize(3);
    ASSERT_TRUE(rooms_.remove(ids).ok());
    ASSERT_TRUE(rooms_.insert(ids, boxes(ids.size())).ok());
  }

  void move() {
    Ids ids = some();
    if (ids.empty()) return;
    if (random_.one_in(3)) {
      for (int again = random_.whole(1, 5); again > 0; --again) ids.push_back(random_.pick(ids));
    }
    std::vector<Aabb> next;
    for (const BodyId id : ids) next.push_back(random_.one_in(3) ? rooms_.held().at(id) : box());
    ASSERT_TRUE(rooms_.move(ids, next).ok());
  }

  /// One body of the call is wrong.
  void refused() {
    if (rooms_.held().empty()) return;
    const auto put_into = [&](Ids ids, BodyId wrong) {
      ids.insert(ids.begin() + static_cast<std::ptrdiff_t>(random_.below(ids.size() + 1)), wrong);
      return ids;
    };
    const Ids held_one = put_into(fresh(5), random_.pick(all()));
    EXPECT_FALSE(rooms_.insert(held_one, boxes(held_one.size())).ok());
    const Ids unknown_one = put_into(some(), 1'999'999'999);
    EXPECT_FALSE(rooms_.move(unknown_one, boxes(unknown_one.size())).ok());
    EXPECT_FALSE(rooms_.remove(unknown_one).ok());
  }

  Rooms& rooms_;
  Random random_;
  BodyId factor_;
};

struct Family {
  const char* name;
  BodyId factor;  ///< between ids
};

void PrintTo(const Family& family, std::ostream* out) {
  *out << family.name;
}

class RandomRooms : public testing::TestWithParam<std::tuple<Family, unsigned>> {};

TEST_P(RandomRooms, HoldWhatPlainMapsHold) {
  const auto& [family, workers] = GetParam();
  Rooms rooms(workers);
  RandomCalls calls(rooms, family.factor + workers, family.factor);
  for (int step = 0; step < 1500 && !HasFailure(); ++step) {
    calls.call();
    if (calls.random().one_in(3)) calls.update();
    if (calls.random().one_in(2)) rooms.expect_right();
    if (step % 300 == 250) calls.crowd();
    if (step % 100 != 99) continue;
    calls.remove_all();
    rooms.update(step % 200 == 99 ? Way::changes : Way::whole_set);
    rooms.expect_right();
    EXPECT_EQ(rooms.bytes(), 0U) << "nobody is left";
  }
  EXPECT_GT(rooms.tidied(), 2);
}

INSTANTIATE_TEST_SUITE_P(Ids, RandomRooms,
                         testing::Combine(testing::Values(Family{"dense", 1}, Family{"mixed", 17'000},
                                                          Family{"scattered", 47'000'000}),
                                          numbers_of_workers()),
                         [](const auto& test) {
                           return std::get<0>(test.param).name + std::string("_with_") +
                                  std::to_string(std::get<1>(test.param)) + "_workers";
                         });

// What was known about the order of the others must not be taken for theirs, after any number of calls.
TEST(BroadphaseOfScatteredIds, NamesBodiesByTheirOwnIdsAfterAllOthersHaveGone) {
  for (std::size_t others = 2; others < 5; ++others) {
    for (std::size_t calls = 2; calls < 12; ++calls) {
      Broadphase broadphase;
      const Ids gone = {40, 30, 20, 10};
      ASSERT_TRUE(broadphase.insert({gone.data(), others}, std::vector<Aabb>(others)).ok());
      ASSERT_TRUE(broadphase.update().ok());
      ASSERT_TRUE(broadphase.remove({gone.data(), others}).ok());
      ASSERT_TRUE(broadphase.update().ok());
      for (std::size_t i = 0; i < calls; ++i) {
        ASSERT_TRUE(
            broadphase.insert(static_cast<BodyId>(900 - i), box_at(2 * static_cast<float>(i / 2))).ok());
      }
      const auto changes = broadphase.update();
      ASSERT_EQ(changes->began.size(), calls / 2);
      for (std::size_t i = 0; i < calls / 2; ++i) {
        const auto first = static_cast<BodyId>(901 - 2 * (calls / 2) + 2 * i);
        EXPECT_EQ(changes->began[i], (Pair{first, first + 1})) << calls << " calls after " << others;
      }
    }
  }
}

}  // namespace
}  // namespace cellsweep
