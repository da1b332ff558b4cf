// falling [TRACE.npz]: cubes fall on a plane, in a world of Bullet whose broadphase is cellsweep's. Leaves a
// trace of what happened, for `cellsweep replay`.
#include <btBulletDynamicsCommon.h>

#include <cstdio>
#include <memory>
#include <vector>

#include "cellsweep_broadphase.h"
#include "world_recorder.h"

int main(int count, char** arguments) {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  CellsweepBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.setGravity({0, -10, 0});

  btStaticPlaneShape plane({0, 1, 0}, 0);
  btBoxShape cube({0.5, 0.5, 0.5});
  btVector3 inertia;
  cube.calculateLocalInertia(1, inertia);
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  bodies.push_back(std::make_unique<btRigidBody>(0, nullptr, &plane));
  for (int i = 0; i < 500; ++i) {
    auto body = std::make_unique<btRigidBody>(1, nullptr, &cube, inertia);
    body->setWorldTransform(
        btTransform(btQuaternion::getIdentity(), {i % 5 * 1.1F, 1.0F + i / 25 * 1.5F, i / 5 % 5 * 1.1F}));
    bodies.push_back(std::move(body));
  }
  for (const auto& body : bodies) world.addRigidBody(body.get());

  WorldRecorder recorder;
  for (int step = 0; step < 300; ++step) {
    world.stepSimulation(1 / btScalar(60), 0);
    const cellsweep::Status recorded = recorder.record(world);
    for (const cellsweep::Status& status : {broadphase.status(), recorded}) {
      if (status.ok()) continue;
      std::puts(status.message.c_str());
      return 1;
    }
    if (step % 60 == 59) {
      std::printf("after %d s: %d pairs, the last cube at a height of %.1f\n", (step + 1) / 60,
                  broadphase.getOverlappingPairCache()->getNumOverlappingPairs(),
                  static_cast<double>(bodies.back()->getWorldTransform().getOrigin().y()));
    }
  }
  for (const auto& body : bodies) world.removeRigidBody(body.get());
  if (count < 2) return 0;
  const cellsweep::Status status = write_trace(recorder.trace(), arguments[1]);
  if (!status.ok()) std::puts(status.message.c_str());
  return status.ok() ? 0 : 1;
}
