#include "bench/bullet/question_rows.h"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cstddef>
#include <random>
#include <string_view>
#include <utility>

#include "base/text.h"
#include "bench/bullet/bullet_world.h"
#include "bench/bullet/contenders.h"
#include "bench/timed_row.h"

namespace cellsweep::bench {
namespace {

constexpr std::size_t kBodies = 20'000;
constexpr int kQuestions = 10'000;
constexpr int kTurns = 3;

struct Box {
  btVector3 low;
  btVector3 high;
};

/// Where the cubes are: the plane below them goes on for ever.
Box bounds_of_cubes(const BulletWorld& world) {
  const btBroadphaseProxy& any = *world.bodies().front()->getBroadphaseProxy();
  Box bounds{any.m_aabbMin, any.m_aabbMax};
  for (const auto& body : world.bodies()) {
    if (body->isStaticObject()) continue;
    bounds.low.setMin(body->getBroadphaseProxy()->m_aabbMin);
    bounds.high.setMax(body->getBroadphaseProxy()->m_aabbMax);
  }
  return bounds;
}

struct CountingBox final : btBroadphaseAabbCallback {
  bool process(const btBroadphaseProxy*) override {
    ++met;
    return true;
  }
  int met = 0;
};

/// Has the numbers that Bullet's callbacks give a ray.
struct CountingRay final : btBroadphaseRayCallback {
  CountingRay(const btVector3& from, const btVector3& to) {
    const btVector3 direction = (to - from).normalized();
    for (int axis = 0; axis < 3; ++axis) {
      m_rayDirectionInverse[axis] = direction[axis] == 0 ? BT_LARGE_FLOAT : 1 / direction[axis];
      m_signs[axis] = m_rayDirectionInverse[axis] < 0 ? 1 : 0;
    }
    m_lambda_max = direction.dot(to - from);
  }
  bool process(const btBroadphaseProxy*) override {
    ++met;
    return true;
  }
  int met = 0;
};

/// Points of chance.
class Points {
 public:
  explicit Points(const Box& bounds) : bounds_(bounds) {}

  btVector3 next() {
    btVector3 point(0, 0, 0);
    for (int axis = 0; axis < 3; ++axis)
      point[axis] = std::uniform_real_distribution<btScalar>(bounds_.low[axis], bounds_.high[axis])(random_);
    return point;
  }

 private:
  Box bounds_;
  std::mt19937 random_{1};
};

int ask_ray(btBroadphaseInterface& broadphase, Points& points) {
  const btVector3 from = points.next();
  const btVector3 to = points.next();
  CountingRay ray(from, to);
  broadphase.rayTest(from, to, ray);
  return ray.met;
}

int ask_box(btBroadphaseInterface& broadphase, Points& points) {
  const btVector3 half(2, 2, 2);
  const btVector3 middle = points.next();
  CountingBox box;
  broadphase.aabbTest(middle - half, middle + half, box);
  return box.met;
}

using Ask = int (*)(btBroadphaseInterface&, Points&);

void run_row(benchmark::State& state, const Contender& contender, Ask ask) {
  constexpr int kFrames = 30;
  BulletWorld world("pile", kBodies, contender.make());
  for (int frame = 0; frame < kFrames; ++frame) world.step();
  const Box bounds = bounds_of_cubes(world);
  for (auto _ : state) {
    Points points(bounds);
    int met = 0;
    const auto start = std::chrono::steady_clock::now();
    for (int question = 0; question < kQuestions; ++question) met += ask(world.broadphase(), points);
    const double all = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    state.SetIterationTime(all / kQuestions);
    state.counters["met"] = static_cast<double>(met) / kQuestions;
  }
}

}  // namespace

void register_questions() {
  constexpr std::pair<std::string_view, Ask> kKinds[] = {{"rays", ask_ray}, {"boxes", ask_box}};
  for (const auto& [kind, ask] : kKinds) {
    for_each_turn(kTurns, [kind = kind, ask = ask](const Contender& contender) {
      register_timed_row(text("bullet/", kind, "/", kBodies, "/", contender.name),
                         [ask, &contender](benchmark::State& state) { run_row(state, contender, ask); });
    });
  }
}

}  // namespace cellsweep::bench
