#include "bullet_questions.h"

#include <LinearMath/btAabbUtil2.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace {

constexpr btScalar kNone = std::numeric_limits<btScalar>::quiet_NaN();
constexpr btScalar kInfinite = std::numeric_limits<btScalar>::infinity();

/// Remembers whom it was called for.
struct BoxAnswers final : btBroadphaseAabbCallback {
  bool process(const btBroadphaseProxy* proxy) override {
    answers.push_back(proxy);
    return true;
  }
  BulletProxies answers;
};

bool meets(const BulletRay& ray, const btBroadphaseProxy& proxy) {
  const btVector3 bounds[2] = {proxy.m_aabbMin - ray.high, proxy.m_aabbMax - ray.low};
  btScalar where = 1;
  return btRayAabb2(ray.from, ray.m_rayDirectionInverse, ray.m_signs, bounds, where, 0, ray.m_lambda_max);
}

testing::AssertionResult same(BulletProxies answers, BulletProxies expected, const char* what) {
  std::sort(answers.begin(), answers.end());
  std::sort(expected.begin(), expected.end());
  if (answers == expected) return testing::AssertionSuccess();
  return testing::AssertionFailure() << what << ": " << answers.size() << " answers and not "
                                     << expected.size();
}

}  // namespace

BulletRay::BulletRay(const btVector3& start, const btVector3& end) : from(start), to(end) {
  const btVector3 direction = (to - from).normalized();
  set_direction(direction, BT_LARGE_FLOAT);
  m_lambda_max = direction.dot(to - from);
}

void BulletRay::set_direction(const btVector3& direction, btScalar inverse_of_zero) {
  for (int axis = 0; axis < 3; ++axis) {
    m_rayDirectionInverse[axis] = direction[axis] == 0 ? inverse_of_zero : 1 / direction[axis];
    m_signs[axis] = m_rayDirectionInverse[axis] < 0 ? 1 : 0;
  }
}

testing::AssertionResult is_answered(btBroadphaseInterface& broadphase, const BulletProxies& there,
                                     BulletRay ray) {
  BulletProxies expected;
  for (const btBroadphaseProxy* const proxy : there) {
    if (meets(ray, *proxy)) expected.push_back(proxy);
  }
  broadphase.rayTest(ray.from, ray.to, ray, ray.low, ray.high);
  const btVector3& inverse = ray.m_rayDirectionInverse;
  return same(std::move(ray.answers), std::move(expected), "a ray")
         << ", from " << ray.from.x() << ", " << ray.from.y() << ", " << ray.from.z() << ", inverse "
         << inverse.x() << ", " << inverse.y() << ", " << inverse.z() << ", up to " << ray.m_lambda_max;
}

testing::AssertionResult is_answered(btBroadphaseInterface& broadphase, const BulletProxies& there,
                                     const btVector3& low, const btVector3& high) {
  BulletProxies expected;
  for (const btBroadphaseProxy* const proxy : there) {
    if (TestAabbAgainstAabb2(low, high, proxy->m_aabbMin, proxy->m_aabbMax)) expected.push_back(proxy);
  }
  BoxAnswers box;
  broadphase.aabbTest(low, high, box);
  return same(std::move(box.answers), std::move(expected), "a box");
}

testing::AssertionResult BulletQuestions::ask(btBroadphaseInterface& broadphase, const BulletProxies& there) {
  for (int i = 0; i < 4; ++i) {
    BulletRay ray = some_ray(there);
    if (const auto result = is_answered(broadphase, there, ray); !result) return result;
    make_odd(ray);
    if (const auto result = is_answered(broadphase, there, ray); !result) return result;
    const btVector3 low = some_point(there);
    btVector3 high = low + some_size();
    if (const auto result = is_answered(broadphase, there, low, high); !result) return result;
    const btScalar odd[] = {low.y() - between(0, 1), kInfinite, kNone};
    high.setY(odd[below(3)]);
    if (const auto result = is_answered(broadphase, there, low, high); !result) return result;
  }
  return testing::AssertionSuccess();
}

btScalar BulletQuestions::between(btScalar low, btScalar high) {
  return low + (high - low) * static_cast<btScalar>(random_() >> 8) / static_cast<btScalar>(1 << 24);
}

// On a corner or an edge, inside or beside of something.
btVector3 BulletQuestions::some_point(const BulletProxies& there) {
  if (there.empty() || below(8) == 0) return {between(-9, 9), between(-9, 9), between(-9, 9)};
  const btBroadphaseProxy& near = *there[below(there.size())];
  btVector3 point;
  for (int axis = 0; axis < 3; ++axis) {
    const btScalar low = std::max<btScalar>(near.m_aabbMin[axis], -50);
    const btScalar high = std::min<btScalar>(near.m_aabbMax[axis], 50);
    const btScalar choices[] = {low, high, (low + high) / 2, low + (high - low) * between(-4, 4)};
    point[axis] = choices[below(4)];
  }
  return point;
}

btVector3 BulletQuestions::some_size() {
  const btScalar most = std::exp2(between(-5, 4));
  return {between(0, most), between(0, most), between(0, most)};
}

BulletRay BulletQuestions::some_ray(const BulletProxies& there) {
  const btVector3 from = some_point(there);
  btVector3 to = some_point(there);
  for (int axis = 0; axis < 3; ++axis) {
    if (below(4) == 0) to[axis] = from[axis];
  }
  if (below(4) == 0) to = from + (to - from) * std::exp2(between(0, 12));
  BulletRay ray(from, to);
  if (below(2) == 0) {
    ray.low = -some_size();
    ray.high = some_size();
  }
  return ray;
}

void BulletQuestions::make_odd(BulletRay& ray) {
  const btScalar ends[] = {0, -1, between(0, 2), 1e9F, BT_LARGE_FLOAT, kInfinite, kNone};
  const int axis = static_cast<int>(below(3));
  switch (below(8)) {
    case 0:
      ray.m_signs[axis] = 1 - ray.m_signs[axis];
      break;
    case 1:
      ray.m_rayDirectionInverse[axis] = kNone;
      break;
    case 2:
      ray.from[axis] = kNone;
      break;
    case 3:
      ray.low[axis] = between(0, 4);  // above the other side, perhaps
      break;
    case 4:
      ray.m_lambda_max = ends[below(std::size(ends))];
      break;
    default:
      ray.set_direction(ray.to - ray.from, below(2) == 0 ? BT_LARGE_FLOAT : kInfinite);
      ray.m_lambda_max = ends[below(std::size(ends))];
  }
}
