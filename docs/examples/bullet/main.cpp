// falling [TRACE.npz [CUBES]]: cubes fall on a plane, in a world of Bullet whose broadphase is cellsweep's.
// Sparks fly up among them and go out again; they do not meet each other. Leaves a trace of what happened,
// for `cellsweep replay`.
#include <btBulletDynamicsCommon.h>

#include <cstdio>
#include <cstdlib>
#include <deque>
#include <memory>
#include <vector>

#include "cellsweep_broadphase.h"
#include "world_recorder.h"

namespace {

constexpr int kSparks = 1 << 8;  // their group
constexpr std::size_t kMostSparks = 12;
constexpr int kLastSpark = 90;  // then all come to rest

using Body = std::unique_ptr<btRigidBody>;

btVector3 inertia_of(btCollisionShape& shape) {
  btVector3 inertia;
  shape.calculateLocalInertia(1, inertia);
  return inertia;
}

Body make_body(btCollisionShape& shape, const btVector3& place) {
  auto body = std::make_unique<btRigidBody>(1, nullptr, &shape, inertia_of(shape));
  body->setWorldTransform(btTransform(btQuaternion::getIdentity(), place));
  body->setSleepingThresholds(2, 2);
  return body;
}

bool is_good(const cellsweep::Status& status) {
  if (!status.ok()) std::puts(status.message.c_str());
  return status.ok();
}

}  // namespace

int main(int count, char** arguments) {
  const int cubes = count > 2 ? std::atoi(arguments[2]) : 500;
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  CellsweepBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity({0, -10, 0});

  btStaticPlaneShape plane({0, 1, 0}, 0);
  btBoxShape cube({0.5, 0.5, 0.5});
  btBoxShape spark({0.1, 0.1, 0.1});
  std::vector<Body> bodies;
  bodies.push_back(std::make_unique<btRigidBody>(0, nullptr, &plane));
  for (int i = 0; i < cubes; ++i)
    bodies.push_back(make_body(cube, {i % 5 * 1.1F, 1.0F + i / 25 * 1.5F, i / 5 % 5 * 1.1F}));
  for (const auto& body : bodies) world.addRigidBody(body.get());

  WorldRecorder recorder;
  std::deque<Body> sparks;
  for (int step = 0; step < 300; ++step) {
    const bool others_come = step < kLastSpark;
    if (others_come && step % 5 == 0) {
      sparks.push_back(make_body(spark, {step % 7 * 1.0F, 0.2F, step % 11 * 0.6F}));
      sparks.back()->setLinearVelocity({step % 3 - 1.0F, 9, step % 4 - 1.5F});
      world.addRigidBody(sparks.back().get(), kSparks, btBroadphaseProxy::AllFilter & ~kSparks);
    }
    if (sparks.size() > (others_come ? kMostSparks : 0)) {
      world.removeRigidBody(sparks.front().get());
      sparks.pop_front();
    }
    world.stepSimulation(1 / btScalar(60), 0);
    if (!is_good(broadphase.status()) || !is_good(recorder.record(world))) return 1;
    if (step % 60 == 59) {
      std::printf("after %d s: %d pairs, the last cube at a height of %.1f\n", (step + 1) / 60,
                  broadphase.getOverlappingPairCache()->getNumOverlappingPairs(),
                  static_cast<double>(bodies.back()->getWorldTransform().getOrigin().y()));
    }
  }
  for (const auto& body : sparks) world.removeRigidBody(body.get());
  for (const auto& body : bodies) world.removeRigidBody(body.get());
  return count < 2 || is_good(write_trace(recorder.trace(), arguments[1])) ? 0 : 1;
}
