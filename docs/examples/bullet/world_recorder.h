/// @file
/// Makes a trace of a world of the physics engine Bullet, whichever broadphase it has.
#pragma once

#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <cellsweep/world/trace_recorder.h>

#include <unordered_map>

/// Looks at all bodies of a world after each step. `cellsweep replay` and `cellsweep verify` read the trace
/// once cellsweep::write_trace() has put it into a file.
class WorldRecorder {
 public:
  /// One frame more: boxes as the broadphase has them, groups and masks; who is in the group of static bodies
  /// alone and does not meet it is static.
  cellsweep::Status record(const btCollisionWorld& world);

  const cellsweep::Trace& trace() const { return recorder_.trace(); }

 private:
  cellsweep::Status record(const btCollisionObject& object, const btBroadphaseProxy& proxy);

  struct Body {
    cellsweep::BodyId id;
    unsigned frame;  // in which it was last seen
  };

  cellsweep::TraceRecorder recorder_;
  std::unordered_map<const btCollisionObject*, Body> bodies_;
  cellsweep::BodyId next_id_ = 0;
  unsigned frame_ = 0;
};
