#include "bench/bullet/bullet_world.h"

#include <cmath>
#include <utility>

namespace cellsweep::bench {
namespace {

btScalar root_of(std::size_t number) {
  return std::sqrt(static_cast<btScalar>(number));
}

}  // namespace

BulletWorld::BulletWorld(std::string_view scene, std::size_t bodies,
                         std::unique_ptr<btBroadphaseInterface> broadphase)
    : broadphase_(std::move(broadphase)), world_(&dispatcher_, broadphase_.get(), &solver_, &configuration_) {
  world_.setGravity({0, -10, 0});
  if (scene == "stacks") {
    build_stacks(bodies);
  } else if (scene == "level") {
    build_level(bodies);
  } else {
    build_pile(bodies, scene == "pile-plane-first");
  }
}

BulletWorld::~BulletWorld() {
  while (!bodies_.empty()) remove(bodies_.size() - 1);
}

void BulletWorld::step() {
  world_.stepSimulation(btScalar(1) / 60, 0);
}

btScalar BulletWorld::chance(btScalar low, btScalar high) {
  return low + (high - low) * static_cast<btScalar>(random_() >> 8) / static_cast<btScalar>(1 << 24);
}

// A mass of 0 is Bullet's word for static.
btRigidBody& BulletWorld::add(btScalar mass, btCollisionShape& shape, const btVector3& place) {
  btVector3 inertia(0, 0, 0);
  if (mass > 0) shape.calculateLocalInertia(mass, inertia);
  auto body = std::make_unique<btRigidBody>(mass, nullptr, &shape, inertia);
  body->setWorldTransform(btTransform(btQuaternion::getIdentity(), place));
  world_.addRigidBody(body.get());
  bodies_.push_back(std::move(body));
  return *bodies_.back();
}

void BulletWorld::remove(std::size_t body) {
  world_.removeRigidBody(bodies_[body].get());
  bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(body));
}

void BulletWorld::spawn_cube() {
  const btVector3 place(chance(0, width_), chance(3, 12), chance(0, width_));
  add(1, cube_, place).setActivationState(DISABLE_DEACTIVATION);
}

void BulletWorld::build_stacks(std::size_t bodies) {
  constexpr std::size_t kHigh = 10;
  constexpr btScalar kApart = 1.5;
  add(0, floor_, {0, -0.5, 0});
  const auto row = static_cast<std::size_t>(std::ceil(root_of(bodies / kHigh)));
  width_ = kApart * static_cast<btScalar>(row);
  for (std::size_t i = 0; i + 1 < bodies; ++i) {
    const std::size_t stack = i / kHigh;
    const btVector3 place(kApart * static_cast<btScalar>(stack % row),
                          btScalar(0.5) + static_cast<btScalar>(i % kHigh),
                          kApart * static_cast<btScalar>(stack / row));
    add(1, cube_, place).setActivationState(DISABLE_DEACTIVATION);
  }
}

// Tiles are two wide and stand a little more than one apart, so that each overlaps its neighbours.
void BulletWorld::build_level(std::size_t bodies) {
  const std::size_t movers = bodies / 20;
  const std::size_t tiles = bodies - movers;
  const auto row = static_cast<std::size_t>(std::ceil(root_of(tiles)));
  constexpr btScalar kApart = 1.1F;
  width_ = kApart * static_cast<btScalar>(row);
  for (std::size_t i = 0; i < tiles; ++i) {
    add(0, tile_, {kApart * static_cast<btScalar>(i % row), -0.5, kApart * static_cast<btScalar>(i / row)});
  }
  for (std::size_t i = 0; i < movers; ++i) {
    btRigidBody& cube = add(1, cube_, {chance(0, width_), chance(1, 4), chance(0, width_)});
    cube.setActivationState(DISABLE_DEACTIVATION);
    cube.setLinearVelocity({chance(-3, 3), 0, chance(-3, 3)});
    cube.setFriction(0);
    cube.setRestitution(1);
  }
}

void BulletWorld::build_pile(std::size_t bodies, bool plane_first) {
  if (plane_first) add(0, plane_, {0, 0, 0});
  constexpr std::size_t kLayers = 8;
  constexpr btScalar kApart = 1.2F;
  const auto row = static_cast<std::size_t>(std::ceil(root_of(bodies / kLayers)));
  width_ = kApart * static_cast<btScalar>(row);
  for (std::size_t i = 0; i + 1 < bodies; ++i) {
    const std::size_t column = i / kLayers;
    const btVector3 place(kApart * static_cast<btScalar>(column % row) + chance(-0.1F, 0.1F),
                          1 + kApart * static_cast<btScalar>(i % kLayers),
                          kApart * static_cast<btScalar>(column / row) + chance(-0.1F, 0.1F));
    add(1, cube_, place).setActivationState(DISABLE_DEACTIVATION);
  }
  if (!plane_first) add(0, plane_, {0, 0, 0});
}

}  // namespace cellsweep::bench
