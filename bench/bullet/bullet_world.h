/// @file
/// Worlds of the physics engine Bullet: resting stacks, a level with few movers, a pile on a plane.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <cstddef>
#include <memory>
#include <random>
#include <span>
#include <string_view>
#include <vector>

namespace cellsweep::bench {

struct BulletScene {
  std::string_view name;
  std::string_view title;  ///< for a person
};

inline constexpr BulletScene kBulletScenes[] = {
    {"stacks", "resting stacks of ten cubes on a floor; nobody falls asleep"},
    {"level", "a level of static tiles that overlap, and 5 % cubes that slide over it and bounce"},
    {"pile", "cubes that fall on a heap, on a plane that came last"},
    {"pile-plane-first", "the same, on a plane that came first"}};

/// A dynamics world with a broadphase of the caller's choice. Two with the same scene, number of bodies and
/// seed begin alike.
class BulletWorld {
 public:
  /// `scene` is one of kBulletScenes, `bodies` at least 10.
  BulletWorld(std::string_view scene, std::size_t bodies, std::unique_ptr<btBroadphaseInterface> broadphase);
  ~BulletWorld();
  BulletWorld(const BulletWorld&) = delete;
  BulletWorld& operator=(const BulletWorld&) = delete;

  /// A sixtieth of a second.
  void step();

  /// A cube comes, somewhere above the others, or a body of the caller's choice goes.
  void spawn_cube();
  void remove(std::size_t body);

  std::span<const std::unique_ptr<btRigidBody>> bodies() const { return bodies_; }
  btDiscreteDynamicsWorld& dynamics() { return world_; }
  btBroadphaseInterface& broadphase() { return *broadphase_; }

 private:
  btRigidBody& add(btScalar mass, btCollisionShape& shape, const btVector3& place);
  void build_stacks(std::size_t bodies);
  void build_level(std::size_t bodies);
  void build_pile(std::size_t bodies, bool plane_first);
  btScalar chance(btScalar low, btScalar high);

  std::mt19937 random_{1};
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btSequentialImpulseConstraintSolver solver_;
  std::unique_ptr<btBroadphaseInterface> broadphase_;
  btStaticPlaneShape plane_{btVector3(0, 1, 0), 0};
  btBoxShape floor_{btVector3(500, 0.5, 500)};
  btBoxShape tile_{btVector3(1, 0.5, 1)};
  btBoxShape cube_{btVector3(0.5, 0.5, 0.5)};
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  btScalar width_ = 0;  // of what the bodies stand on
};

}  // namespace cellsweep::bench
