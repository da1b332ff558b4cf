/// @file
/// The rigid-body world of the document's chapter 3.3: solid boxes that fly and spin between six planes.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/export.h"
#include "cellsweep/pair.h"
#include "cellsweep/status.h"

namespace cellsweep {

/// An RGB colour, 0 to 1 a channel.
using Color = std::array<float, 3>;

/// A solid box that owns its bounding box (W1). Lengths in world units, velocities per frame.
struct CELLSWEEP_API RigidBody {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< the centre
  Eigen::Vector3f half_extents = Eigen::Vector3f::Constant(0.5F);
  Eigen::Quaternionf orientation = Eigen::Quaternionf::Identity();
  Eigen::Vector3f velocity = Eigen::Vector3f::Zero();
  Eigen::Vector3f angular_velocity = Eigen::Vector3f::Zero();  ///< radians per frame, about the world's axes
  bool dynamic = false;                                        ///< a body that is not never moves
  Color color{};                                               ///< as World::color_collisions() set it
  Aabb box;                                                    ///< as update_box() left it

  /// Recomputes `box` from position, orientation and half extents; it grows to enclose a rotated body (W2),
  /// to within a few float steps of its size and position. A body that is not turned has exactly position ±
  /// half extents. The orientation may be a quaternion of any length but zero.
  void update_box();
};

/// What a world shows colliding and other bodies as (W4).
struct WorldColors {
  Color plain = {0.70F, 0.70F, 0.75F};
  Color colliding = {0.20F, 0.80F, 0.25F};
};

/// Bodies with ids, inside six planes that turn them back (W3). The same calls give the same bits on every
/// machine: only + − × ÷ √ on floats, in a fixed order. One thread at a time.
class CELLSWEEP_API World {
 public:
  /// A world with the given bounds, empty. Bounds stop no body from being added outside of them.
  explicit World(const Aabb& bounds, const WorldColors& colors = {});

  const Aabb& bounds() const { return bounds_; }

  /// Adds a body, its box brought up to date and its colour plain, and gives it the next id; ids are not used
  /// twice (W6), so a world takes 2^32 bodies in its life.
  BodyId add(const RigidBody& body);

  /// Takes a body out. Errors: unknown_body.
  Status remove(BodyId id);

  /// The body, or null when there is none of that id. Valid until the next add or remove.
  RigidBody* find(BodyId id);
  const RigidBody* find(BodyId id) const;

  std::size_t size() const { return bodies_.size(); }

  /// The ids of all bodies, ascending, and the bodies in the same order.
  std::span<const BodyId> ids() const { return ids_; }
  std::span<const RigidBody> bodies() const { return bodies_; }

  /// Moves and turns every dynamic body by one frame. A body that has passed a plane and is moving outwards
  /// has its velocity inverted on that axis (W3).
  void step();

  /// The ids of the bodies whose box the last step() changed, ascending, without those removed since.
  std::span<const BodyId> moved() const { return moved_; }

  /// Gives the bodies that are in a pair the colliding colour and all others the plain one (W4).
  void color_collisions(std::span<const Pair> pairs);

 private:
  std::size_t index_of(BodyId id) const;

  Aabb bounds_;
  WorldColors colors_;
  BodyId next_id_ = 0;
  std::vector<BodyId> ids_;
  std::vector<RigidBody> bodies_;
  std::vector<BodyId> moved_;
};

}  // namespace cellsweep
