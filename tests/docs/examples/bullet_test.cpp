/// @file
/// The broadphase for Bullet of docs/examples beside Bullet's own tree, in worlds that Bullet moves.
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btGhostObject.h>
#include <LinearMath/btAabbUtil2.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bench/bullet/bullet_world.h"
#include "bullet_questions.h"
#include "cellsweep_broadphase.h"
#include "report/oracle.h"
#include "world_recorder.h"

namespace {

using cellsweep::bench::BulletWorld;

/// Two clients, the one at the lower address first.
using ClientPair = std::pair<const void*, const void*>;

ClientPair clients_of(const btBroadphasePair& pair) {
  return std::minmax<const void*>(pair.m_pProxy0->m_clientObject, pair.m_pProxy1->m_clientObject);
}

std::set<ClientPair> listed_pairs_of(btBroadphaseInterface& broadphase) {
  std::set<ClientPair> pairs;
  for (int i = 0; i < broadphase.getOverlappingPairCache()->getNumOverlappingPairs(); ++i)
    pairs.insert(clients_of(broadphase.getOverlappingPairCache()->getOverlappingPairArrayPtr()[i]));
  return pairs;
}

/// All of them whose boxes overlap.
std::set<ClientPair> pairs_of(btBroadphaseInterface& broadphase) {
  std::set<ClientPair> pairs;
  for (int i = 0; i < broadphase.getOverlappingPairCache()->getNumOverlappingPairs(); ++i) {
    const btBroadphasePair& pair = broadphase.getOverlappingPairCache()->getOverlappingPairArrayPtr()[i];
    const btBroadphaseProxy& one = *pair.m_pProxy0;
    const btBroadphaseProxy& other = *pair.m_pProxy1;
    if (TestAabbAgainstAabb2(one.m_aabbMin, one.m_aabbMax, other.m_aabbMin, other.m_aabbMax))
      pairs.insert(clients_of(pair));
  }
  return pairs;
}

/// Bullet's tree, of which each body of a world has a proxy with the same box and filter.
class Shadow {
 public:
  ~Shadow() {
    for (const auto& [body, proxy] : proxies_) tree_.destroyProxy(proxy, &dispatcher_);
  }

  void follow(const BulletWorld& world) {
    std::set<const btRigidBody*> present;
    for (const auto& body : world.bodies()) {
      present.insert(body.get());
      const btBroadphaseProxy& original = *body->getBroadphaseProxy();
      btBroadphaseProxy*& proxy = proxies_[body.get()];
      if (proxy == nullptr) {
        proxy =
            tree_.createProxy(original.m_aabbMin, original.m_aabbMax, 0, original.m_clientObject,
                              original.m_collisionFilterGroup, original.m_collisionFilterMask, &dispatcher_);
      }
      tree_.setAabb(proxy, original.m_aabbMin, original.m_aabbMax, &dispatcher_);
    }
    for (auto entry = proxies_.begin(); entry != proxies_.end();) {
      if (present.contains(entry->first)) {
        ++entry;
        continue;
      }
      tree_.destroyProxy(entry->second, &dispatcher_);
      entry = proxies_.erase(entry);
    }
    tree_.calculateOverlappingPairs(&dispatcher_);
  }

  btBroadphaseInterface& tree() { return tree_; }

 private:
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase tree_;
  std::map<const btRigidBody*, btBroadphaseProxy*> proxies_;
};

/// The boxes that a broadphase with a margin goes by, as its documentation says, and which of them overlap.
class FatBoxes {
 public:
  explicit FatBoxes(btScalar margin) : margin_(margin, margin, margin) {}

  void follow(const BulletWorld& world) {
    std::map<const void*, Box> boxes;
    for (const auto& body : world.bodies()) {
      const btBroadphaseProxy& proxy = *body->getBroadphaseProxy();
      const auto known = boxes_.find(proxy.m_clientObject);
      Box box = known != boxes_.end() ? known->second : Box{&proxy, proxy.m_aabbMin, proxy.m_aabbMax};
      if (!is_inside(proxy, box)) box = {&proxy, proxy.m_aabbMin - margin_, proxy.m_aabbMax + margin_};
      boxes.insert_or_assign(proxy.m_clientObject, box);
    }
    boxes_ = std::move(boxes);
  }

  std::set<ClientPair> pairs() const {
    std::set<ClientPair> pairs;
    for (auto one = boxes_.begin(); one != boxes_.end(); ++one) {
      for (auto other = boxes_.begin(); other != one; ++other) {
        const Box& a = one->second;
        const Box& b = other->second;
        if (may_meet(*a.proxy, *b.proxy) && TestAabbAgainstAabb2(a.low, a.high, b.low, b.high))
          pairs.insert({other->first, one->first});
      }
    }
    return pairs;
  }

 private:
  struct Box {
    const btBroadphaseProxy* proxy;
    btVector3 low;
    btVector3 high;
  };

  static bool is_inside(const btBroadphaseProxy& proxy, const Box& box) {
    btVector3 low = box.low;
    btVector3 high = box.high;
    low.setMin(proxy.m_aabbMin);
    high.setMax(proxy.m_aabbMax);
    return low == box.low && high == box.high;
  }
  static bool may_meet(const btBroadphaseProxy& one, const btBroadphaseProxy& other) {
    return (one.m_collisionFilterGroup & other.m_collisionFilterMask) != 0 &&
           (other.m_collisionFilterGroup & one.m_collisionFilterMask) != 0;
  }

  btVector3 margin_;
  std::map<const void*, Box> boxes_;
};

constexpr btScalar kMargin = 0.05F;

std::unique_ptr<CellsweepBroadphase> make_ours(btScalar margin) {
  return std::make_unique<CellsweepBroadphase>(cellsweep::Broadphase(), margin);
}

class WorldOfBullet : public testing::TestWithParam<std::string> {};

#ifdef CELLSWEEP_SANITIZED_TESTS
constexpr int kFrames = 150;
#else
constexpr int kFrames = 1000;
#endif

// The boxes are looked at where the pairs were found with them: before they are moved on in the next step.
TEST_P(WorldOfBullet, HasThePairsThatBulletsTreeFindsThroughAThousandFrames) {
  constexpr std::size_t kBodies = 120;
  BulletWorld world(GetParam(), kBodies, std::make_unique<CellsweepBroadphase>());
  Shadow shadow;
  std::mt19937 random(5);
  std::size_t seen = 0;
  // Cubes only, where all stand on one floor.
  const auto remove_one = [&] {
    std::size_t body = 0;
    do {
      body = random() % world.bodies().size();
    } while (GetParam() != "level" && world.bodies()[body]->isStaticObject());
    world.remove(body);
  };
  for (int frame = 0; frame < kFrames; ++frame) {
    if (frame % 3 == 0) world.spawn_cube();
    if (frame % 3 == 1) remove_one();
    world.step();
    ASSERT_TRUE(static_cast<CellsweepBroadphase&>(world.broadphase()).status().ok());
    shadow.follow(world);
    const std::set<ClientPair> expected = pairs_of(shadow.tree());
    ASSERT_EQ(pairs_of(world.broadphase()), expected) << "frame " << frame;
    ASSERT_EQ(world.broadphase().getOverlappingPairCache()->getNumOverlappingPairs(),
              static_cast<int>(expected.size()))
        << "nothing is listed that does not overlap, frame " << frame;
    seen += expected.size();
  }
  EXPECT_GT(seen, static_cast<std::size_t>(3 * kFrames));
}

TEST_P(WorldOfBullet, HasThePairsOfFatBoxesWhereThereIsAMargin) {
  BulletWorld world(GetParam(), 120, make_ours(kMargin));
  FatBoxes boxes(kMargin);
  std::mt19937 random(6);
  std::size_t apart = 0;
  for (int frame = 0; frame < kFrames / 2; ++frame) {
    if (frame % 3 == 0) world.spawn_cube();
    if (frame % 3 == 1) world.remove(random() % world.bodies().size());
    world.step();
    ASSERT_TRUE(static_cast<CellsweepBroadphase&>(world.broadphase()).status().ok());
    boxes.follow(world);
    const std::set<ClientPair> overlapping = pairs_of(world.broadphase());
    const std::set<ClientPair> listed = listed_pairs_of(world.broadphase());
    ASSERT_EQ(listed, boxes.pairs()) << "frame " << frame;
    apart += listed.size() - overlapping.size();
  }
  EXPECT_GT(apart, static_cast<std::size_t>(kFrames / 10)) << "of pairs that do not overlap";
}

BulletProxies proxies_of(const BulletWorld& world) {
  BulletProxies proxies;
  for (const auto& body : world.bodies()) proxies.push_back(body->getBroadphaseProxy());
  return proxies;
}

// After bodies came and went, after all boxes were given anew, and after the pairs were found.
TEST_P(WorldOfBullet, AnswersQuestionsAsALoopDoesAtAnyTime) {
  BulletWorld world(GetParam(), 120, make_ours(GetParam() == "level" ? kMargin : 0));
  BulletQuestions questions(11);
  for (int frame = 0; frame < kFrames / 2; ++frame) {
    if (frame % 3 == 0) world.spawn_cube();
    if (frame % 3 == 1) world.remove(questions.below(world.bodies().size()));
    ASSERT_TRUE(questions.ask(world.broadphase(), proxies_of(world))) << "before frame " << frame;
    world.dynamics().updateAabbs();
    ASSERT_TRUE(questions.ask(world.broadphase(), proxies_of(world))) << "in frame " << frame;
    world.step();
    ASSERT_TRUE(questions.ask(world.broadphase(), proxies_of(world))) << "after frame " << frame;
  }
}

TEST_P(WorldOfBullet, LeavesATraceWithThePairsOfEveryFrame) {
  BulletWorld world(GetParam(), 60, std::make_unique<CellsweepBroadphase>());
  WorldRecorder recorder;
  std::vector<std::size_t> expected;
  for (int frame = 0; frame < 60; ++frame) {
    if (frame % 4 == 1) world.spawn_cube();
    if (frame % 4 == 3) world.remove(world.bodies().size() - 1);
    world.step();
    ASSERT_TRUE(recorder.record(world.dynamics()).ok());
    expected.push_back(pairs_of(world.broadphase()).size());
  }
  const auto frames = make_trace_frames(std::make_shared<const cellsweep::Trace>(recorder.trace()));
  EXPECT_TRUE(frames->bodies_come_and_go());
  for (int frame = 0; frame < 60; ++frame) {
    ASSERT_EQ(cellsweep::report::oracle_pairs(*frames).size(), expected[frame]) << "frame " << frame;
    frames->advance();
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, WorldOfBullet,
                         testing::Values("stacks", "level", "pile", "pile-plane-first"), [](const auto& of) {
                           std::string name = of.param;
                           std::erase(name, '-');
                           return name;
                         });

/// A few proxies without a world.
class ProxiesOfBullet : public testing::Test {
 protected:
  btBroadphaseProxy* add(btScalar x, int group = btBroadphaseProxy::DefaultFilter,
                         int mask = btBroadphaseProxy::AllFilter) {
    clients_.push_back(std::make_unique<int>(0));
    return broadphase_.createProxy({x, 0, 0}, {x + 1, 1, 1}, BOX_SHAPE_PROXYTYPE, clients_.back().get(),
                                   group, mask, &dispatcher_);
  }
  int pairs() {
    broadphase_.calculateOverlappingPairs(&dispatcher_);
    return broadphase_.getOverlappingPairCache()->getNumOverlappingPairs();
  }

  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  CellsweepBroadphase broadphase_;
  std::vector<std::unique_ptr<int>> clients_;
};

TEST_F(ProxiesOfBullet, MeetWhereGroupsAndMasksSaySo) {
  constexpr int kStatic = btBroadphaseProxy::StaticFilter;
  constexpr int kDebris = btBroadphaseProxy::DebrisFilter;
  add(0, kStatic, btBroadphaseProxy::AllFilter ^ kStatic);
  add(0, kStatic, btBroadphaseProxy::AllFilter ^ kStatic);
  EXPECT_EQ(pairs(), 0);
  add(0);
  EXPECT_EQ(pairs(), 2);
  add(0, kDebris, kStatic);
  EXPECT_EQ(pairs(), 4);
  add(0, kStatic, kStatic | kDebris);
  EXPECT_EQ(pairs(), 5) << "with the debris, whose mask it is in; the other two do not want it";
}

/// Wants pairs of clients whose numbers are equal, whatever groups say.
struct EqualClients final : btOverlapFilterCallback {
  bool needBroadphaseCollision(btBroadphaseProxy* one, btBroadphaseProxy* other) const override {
    return *static_cast<int*>(one->m_clientObject) == *static_cast<int*>(other->m_clientObject);
  }
};

TEST_F(ProxiesOfBullet, MeetWhereACallbackSaysSo) {
  EqualClients equal;
  for (int i = 0; i < 4; ++i) {
    add(0, btBroadphaseProxy::StaticFilter, 0);
    *clients_.back() = i / 2;
  }
  EXPECT_EQ(pairs(), 0);
  broadphase_.getOverlappingPairCache()->setOverlapFilterCallback(&equal);
  EXPECT_EQ(pairs(), 2);
  add(0, 0, 0);
  EXPECT_EQ(pairs(), 4);
}

TEST_F(ProxiesOfBullet, MeetByGroupsAgainWhenACallbackIsTakenAway) {
  EqualClients equal;
  for (int i = 0; i < 4; ++i) {
    add(0);
    *clients_.back() = i / 2;
  }
  broadphase_.getOverlappingPairCache()->setOverlapFilterCallback(&equal);
  EXPECT_EQ(pairs(), 2);
  broadphase_.getOverlappingPairCache()->setOverlapFilterCallback(nullptr);
  EXPECT_EQ(pairs(), 6) << "those that it refused, too";
}

TEST_F(ProxiesOfBullet, MayGoBeforeAnybodyHeardOfThemAndTheirPlacesAreTakenAgain) {
  btBroadphaseProxy* const one = add(0);
  btBroadphaseProxy* const other = add(0);
  broadphase_.destroyProxy(one, &dispatcher_);
  add(0);
  EXPECT_EQ(pairs(), 1);
  broadphase_.destroyProxy(other, &dispatcher_);
  EXPECT_EQ(broadphase_.getOverlappingPairCache()->getNumOverlappingPairs(), 0) << "at once";
  add(0);
  add(5);
  EXPECT_EQ(pairs(), 1);
  EXPECT_EQ(broadphase_.broadphase().size(), 3U);
}

TEST_F(ProxiesOfBullet, HaveALineOfTheCachesToThemselves) {
  for (int i = 0; i < 5000; ++i) ASSERT_EQ(reinterpret_cast<std::uintptr_t>(add(btScalar(i))) % 64, 0U) << i;
}

TEST_F(ProxiesOfBullet, AreWhereTheyWereSaidToBeLast) {
  btBroadphaseProxy* const one = add(0);
  add(3);
  EXPECT_EQ(pairs(), 0);
  broadphase_.setAabb(one, {9, 0, 0}, {10, 1, 1}, &dispatcher_);
  broadphase_.setAabb(one, {4, 0, 0}, {5, 1, 1}, &dispatcher_);
  EXPECT_EQ(pairs(), 1) << "they touch";
  btVector3 low, high;
  broadphase_.getAabb(one, low, high);
  EXPECT_EQ(low, btVector3(4, 0, 0));
  broadphase_.getBroadphaseAabb(low, high);
  EXPECT_EQ(low, btVector3(3, 0, 0));
  EXPECT_EQ(high, btVector3(5, 1, 1));
}

/// Remembers whom it was called for.
struct Listing final : btBroadphaseAabbCallback {
  bool process(const btBroadphaseProxy* proxy) override {
    clients.insert(proxy->m_clientObject);
    return true;
  }
  std::set<void*> clients;
};

TEST_F(ProxiesOfBullet, AreFoundByABox) {
  for (int i = 0; i < 6; ++i) add(static_cast<btScalar>(2 * i));
  Listing listing;
  broadphase_.aabbTest({2, 0, 0}, {5, 1, 1}, listing);
  EXPECT_THAT(listing.clients, testing::UnorderedElementsAre(clients_[1].get(), clients_[2].get()));
}

TEST(BulletBroadphase, RefusesAMarginThatIsNoLength) {
  constexpr btScalar kLimits[] = {-1, std::numeric_limits<btScalar>::infinity(),
                                  std::numeric_limits<btScalar>::quiet_NaN()};
  for (const btScalar margin : kLimits) EXPECT_THROW(make_ours(margin), std::invalid_argument) << margin;
}

// What was refused may have room for everything.
TEST(BulletBroadphase, ABoxThatWasRefusedIsForgottenForTheNextOneWhateverItsRoom) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  const auto broadphase = make_ours(kMargin);
  btBroadphaseProxy* const proxy =
      broadphase->createProxy({0, 0, 0}, {1, 1, 1}, BOX_SHAPE_PROXYTYPE, nullptr, 1, -1, &dispatcher);
  broadphase->calculateOverlappingPairs(&dispatcher);
  broadphase->setAabb(proxy, {0, 0, 0}, {1, 1, HUGE_VALF}, &dispatcher);
  broadphase->calculateOverlappingPairs(&dispatcher);
  EXPECT_FALSE(broadphase->status().ok());
  broadphase->setAabb(proxy, {0, 0, 0}, {1, 1, 2}, &dispatcher);
  broadphase->calculateOverlappingPairs(&dispatcher);
  EXPECT_TRUE(broadphase->status().ok()) << broadphase->status().message;
}

TEST(BulletBroadphase, AProxyHasNoRoomFromTheOneBeforeInItsPlace) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  const auto broadphase = make_ours(kMargin);
  const auto add = [&](btScalar x) {
    return broadphase->createProxy({x, 0, 0}, {x + 1, 1, 1}, 0, nullptr, 1, -1, &dispatcher);
  };
  const auto move = [&](btBroadphaseProxy* proxy, btScalar x) {
    broadphase->setAabb(proxy, {x, 0, 0}, {x + 1, 1, 1}, &dispatcher);
    broadphase->calculateOverlappingPairs(&dispatcher);
  };
  add(20);
  btBroadphaseProxy* const gone = add(0);
  broadphase->calculateOverlappingPairs(&dispatcher);
  move(gone, 20);
  broadphase->destroyProxy(gone, &dispatcher);
  broadphase->calculateOverlappingPairs(&dispatcher);
  btBroadphaseProxy* const next = add(10);
  ASSERT_EQ(next, gone);
  broadphase->calculateOverlappingPairs(&dispatcher);
  EXPECT_EQ(broadphase->getOverlappingPairCache()->getNumOverlappingPairs(), 0);
  move(next, 20);
  EXPECT_EQ(broadphase->getOverlappingPairCache()->getNumOverlappingPairs(), 1);
}

TEST(BulletBroadphase, ARefusalLeavesThePairsAndTheNextStepTakesUpWhatWasNotHeard) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  auto made = cellsweep::make_broadphase(cellsweep::StreamOptions{.max_pairs = 3});
  ASSERT_TRUE(made);
  CellsweepBroadphase broadphase(std::move(*made));
  const auto add = [&] {
    return broadphase.createProxy({0, 0, 0}, {1, 1, 1}, BOX_SHAPE_PROXYTYPE, &dispatcher, 1, -1, &dispatcher);
  };
  const auto pairs = [&] {
    broadphase.calculateOverlappingPairs(&dispatcher);
    return broadphase.getOverlappingPairCache()->getNumOverlappingPairs();
  };
  add();
  add();
  add();
  EXPECT_EQ(pairs(), 3);
  btBroadphaseProxy* const fourth = add();
  EXPECT_EQ(pairs(), 3);
  EXPECT_EQ(broadphase.status().code, cellsweep::StatusCode::capacity);
  EXPECT_THAT(broadphase.status().message, testing::HasSubstr("max_pairs"));
  EXPECT_EQ(pairs(), 3) << "again";
  broadphase.destroyProxy(fourth, &dispatcher);
  EXPECT_EQ(pairs(), 3);
  EXPECT_TRUE(broadphase.status().ok());
}

/// The nearest hit of each of many rays through a world.
std::vector<btScalar> nearest_hits(const btCollisionWorld& world) {
  std::vector<btScalar> hits;
  for (int i = 0; i < 200; ++i) {
    const btVector3 from(btScalar(i % 20) - 4, 30, btScalar(i / 20) - 2);
    const btVector3 to(btScalar(i / 20), -5, btScalar(i % 20));
    btCollisionWorld::ClosestRayResultCallback nearest(from, to);
    world.rayTest(from, to, nearest);
    hits.push_back(nearest.hasHit() ? nearest.m_closestHitFraction : btScalar(2));
  }
  return hits;
}

TEST(BulletBroadphase, RaysHitWhatTheyHitInBulletsTree) {
  BulletWorld ours("pile", 200, std::make_unique<CellsweepBroadphase>());
  BulletWorld bullets("pile", 200, std::make_unique<btDbvtBroadphase>());
  EXPECT_EQ(nearest_hits(ours.dynamics()), nearest_hits(bullets.dynamics()));
  EXPECT_THAT(nearest_hits(ours.dynamics()), testing::Contains(testing::Lt(btScalar(1))));
}

TEST(BulletBroadphase, GhostsKnowWhomTheyOverlap) {
  btGhostPairCallback ghost_pairs;
  BulletWorld world("pile", 60, std::make_unique<CellsweepBroadphase>());
  world.broadphase().getOverlappingPairCache()->setInternalGhostPairCallback(&ghost_pairs);
  btBoxShape shape({100, 100, 100});
  btGhostObject ghost;
  ghost.setCollisionShape(&shape);
  ghost.setCollisionFlags(btCollisionObject::CF_NO_CONTACT_RESPONSE);
  world.dynamics().addCollisionObject(&ghost, btBroadphaseProxy::SensorTrigger,
                                      btBroadphaseProxy::DefaultFilter);
  world.step();
  EXPECT_EQ(ghost.getNumOverlappingObjects(), 59) << "the cubes, not the plane";
  world.remove(0);
  EXPECT_EQ(ghost.getNumOverlappingObjects(), 58);
  world.dynamics().removeCollisionObject(&ghost);
}

}  // namespace
