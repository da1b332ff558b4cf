/// @file
/// What the broadphase for Bullet of docs/examples says to rays and boxes, whatever it has not yet heard of.
#include <gmock/gmock.h>

#include <cmath>
#include <cstddef>
#include <utility>

#include "bullet_questions.h"
#include "cellsweep_broadphase.h"

namespace {

#ifdef CELLSWEEP_SANITIZED_TESTS
constexpr int kRounds = 600;
#else
constexpr int kRounds = 4000;
#endif

/// Proxies that come, move and go, and a broadphase that may refuse to follow.
class Crowd {
 public:
  explicit Crowd(cellsweep::StreamOptions options, btScalar margin = 0)
      : broadphase_(std::move(*cellsweep::make_broadphase(options)), margin) {}

  CellsweepBroadphase& broadphase() { return broadphase_; }
  const BulletProxies& there() const { return there_; }

  void create(const btVector3& low, const btVector3& high) {
    const int all = btBroadphaseProxy::AllFilter;
    there_.push_back(broadphase_.createProxy(low, high, 0, this, 1, all, nullptr));
  }
  void move(std::size_t which, const btVector3& low, const btVector3& high) {
    broadphase_.setAabb(proxy(which), low, high, nullptr);
  }
  void nudge(std::size_t which, const btVector3& by) {
    move(which, there_[which]->m_aabbMin + by, there_[which]->m_aabbMax + by);
  }
  void destroy(std::size_t which) {
    broadphase_.destroyProxy(proxy(which), nullptr);
    there_.erase(there_.begin() + static_cast<std::ptrdiff_t>(which));
  }
  bool update() {
    broadphase_.calculateOverlappingPairs(nullptr);
    return broadphase_.status().ok();
  }

 private:
  btBroadphaseProxy* proxy(std::size_t which) { return const_cast<btBroadphaseProxy*>(there_[which]); }

  CellsweepBroadphase broadphase_;
  BulletProxies there_;
};

class BulletQuestionsWithMargin : public testing::TestWithParam<float> {};

// Too many pairs are refused when all has been told, and an infinite box in the midst of it.
TEST_P(BulletQuestionsWithMargin, AreAnsweredFromTheBoxesAsTheyAreWhateverWasToldSeenOrRefused) {
  Crowd crowd({.max_pairs = 60}, GetParam());
  BulletQuestions questions(3);
  const auto place = [&] {
    return btVector3(questions.between(-5, 5), questions.between(-5, 5), questions.between(-5, 5));
  };
  const btVector3 infinite(1, 1, HUGE_VALF);
  int refused = 0;
  int accepted = 0;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t change = questions.below(4); change > 0; --change) {
      const btVector3 low = place();
      const btVector3 high = questions.below(40) == 0 ? infinite : low + btVector3(2, 2, 2);
      const std::size_t count = crowd.there().size();
      const std::size_t which = count == 0 ? 0 : questions.below(count);
      switch (count < 5 ? 0 : questions.below(count > 40 ? 5 : 4)) {
        case 0:
          crowd.create(low, high);
          break;
        case 1:
          crowd.move(which, low, high);
          break;
        case 2:
          crowd.nudge(which, (low + high) / 40);
          break;
        default:
          crowd.destroy(which);
      }
    }
    ASSERT_TRUE(questions.ask(crowd.broadphase(), crowd.there())) << "before the update of round " << round;
    if (questions.below(3) == 0) continue;
    (crowd.update() ? accepted : refused) += 1;
    ASSERT_TRUE(questions.ask(crowd.broadphase(), crowd.there())) << "after the update of round " << round;
  }
  EXPECT_GT(refused, kRounds / 20);
  EXPECT_GT(accepted, kRounds / 20);
}

// Aimed at corners from far away, where a rounding decides.
TEST_P(BulletQuestionsWithMargin, LoseNothingThatARayGrazes) {
  Crowd crowd({}, GetParam());
  BulletQuestions questions(7);
  const auto place = [&](btScalar far) {
    return btVector3(questions.between(-far, far), questions.between(-far, far),
                     questions.between(-far, far));
  };
  for (int i = 0; i < 300; ++i) {
    const btVector3 low = place(100);
    crowd.create(low, low + btVector3(1, 1, 1));
  }
  ASSERT_TRUE(crowd.update());
  for (int i = 0; i < 5 * kRounds; ++i) {
    const btBroadphaseProxy& target = *crowd.there()[questions.below(300)];
    btVector3 corner = target.m_aabbMin;
    for (int axis = 0; axis < 3; ++axis) {
      if (questions.below(2) == 0) corner[axis] = target.m_aabbMax[axis];
    }
    BulletRay ray(place(i % 2 == 0 ? 100 : 1e5F), corner);
    if (i % 3 == 0) {
      ray.low = place(1) - btVector3(1, 1, 1);
      ray.high = ray.low + btVector3(3, 3, 3);
    }
    if (i % 5 == 0) ray.m_lambda_max *= 100;
    ASSERT_TRUE(is_answered(crowd.broadphase(), crowd.there(), ray)) << "ray " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Margins, BulletQuestionsWithMargin, testing::Values(0.0F, 0.5F),
                         [](const auto& of) { return of.param > 0 ? "Half" : "None"; });

/// Six boxes in a row, each two behind the one before.
class RowOfBullet : public testing::Test {
 protected:
  RowOfBullet() {
    for (int i = 0; i < 6; ++i) {
      const btVector3 low(static_cast<btScalar>(2 * i), 0, 0);
      crowd_.create(low, low + btVector3(1, 1, 1));
    }
    crowd_.update();
  }
  CellsweepBroadphase& broadphase() { return crowd_.broadphase(); }

  Crowd crowd_{{}};
  const btVector3 from_{-3, 0.5, 0.5};
  const btVector3 to_{20, 0.5, 0.5};
};

TEST_F(RowOfBullet, IsMetFromTheFirstToTheLast) {
  BulletRay ray(from_, to_);
  broadphase().rayTest(from_, to_, ray);
  EXPECT_EQ(ray.answers, crowd_.there());
}

/// Goes no further than to what it met.
struct ShortenedRay final : btBroadphaseRayCallback {
  explicit ShortenedRay(const BulletRay& ray) : btBroadphaseRayCallback(ray) {}
  bool process(const btBroadphaseProxy* proxy) override {
    ++answers;
    m_lambda_max = proxy->m_aabbMin.x() + 3;
    return true;
  }
  int answers = 0;
};

TEST_F(RowOfBullet, IsLeftOutBehindTheEndOfARayThatWasShortened) {
  ShortenedRay ray(BulletRay(from_, to_));
  broadphase().rayTest(from_, to_, ray);
  EXPECT_EQ(ray.answers, 1);
}

/// Asks for what is in the box of each that it meets.
struct AskingRay final : btBroadphaseRayCallback {
  AskingRay(const BulletRay& ray, CellsweepBroadphase& of) : btBroadphaseRayCallback(ray), broadphase(of) {}
  bool process(const btBroadphaseProxy* proxy) override {
    BulletRay inner(proxy->m_aabbMin, proxy->m_aabbMax);
    broadphase.rayTest(inner.from, inner.to, inner);
    EXPECT_THAT(inner.answers, testing::ElementsAre(proxy));
    ++answers;
    return true;
  }
  CellsweepBroadphase& broadphase;
  int answers = 0;
};

TEST_F(RowOfBullet, MayBeAskedWhileItAnswers) {
  AskingRay ray(BulletRay(from_, to_), broadphase());
  broadphase().rayTest(from_, to_, ray);
  EXPECT_EQ(ray.answers, 6);
}

}  // namespace
