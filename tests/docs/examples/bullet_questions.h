/// @file
/// Rays, casts and boxes that a broadphase of Bullet is asked for, beside a loop over all that is there.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <random>
#include <vector>

/// Proxies that are there, or that were answers.
using BulletProxies = std::vector<const btBroadphaseProxy*>;

/// A ray as Bullet's own callbacks have it, or with numbers of the caller's; remembers whom it was called
/// for.
struct BulletRay final : btBroadphaseRayCallback {
  BulletRay() : BulletRay({0, 0, 0}, {1, 0, 0}) {}
  BulletRay(const btVector3& start, const btVector3& end);

  /// The same questions for a direction that need not be of length 1.
  void set_direction(const btVector3& direction, btScalar inverse_of_zero);

  bool process(const btBroadphaseProxy* proxy) override {
    answers.push_back(proxy);
    return true;
  }

  btVector3 from;
  btVector3 to;
  btVector3 low{0, 0, 0};  ///< of the box that is cast
  btVector3 high{0, 0, 0};
  BulletProxies answers;
};

/// All that a ray meets, or that a box overlaps, by looking at each; and what the broadphase says.
testing::AssertionResult is_answered(btBroadphaseInterface& broadphase, const BulletProxies& there,
                                     BulletRay ray);
testing::AssertionResult is_answered(btBroadphaseInterface& broadphase, const BulletProxies& there,
                                     const btVector3& low, const btVector3& high);

/// Makes questions near to what is there: thin rays and casts, along an axis or not, of no length, from
/// inside of something, to edges; and such as no ray of Bullet is.
class BulletQuestions {
 public:
  explicit BulletQuestions(unsigned seed) : random_(seed) {}

  /// A few of each kind.
  testing::AssertionResult ask(btBroadphaseInterface& broadphase, const BulletProxies& there);

  btScalar between(btScalar low, btScalar high);
  std::size_t below(std::size_t number) { return random_() % number; }

 private:
  btVector3 some_point(const BulletProxies& there);
  btVector3 some_size();
  BulletRay some_ray(const BulletProxies& there);
  void make_odd(BulletRay& ray);

  std::mt19937 random_;
};
