/// @file
/// The part of the contract that is the same in every engine: input is checked whole, then applied whole.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "broadphase/body_table.h"
#include "cellsweep/broadphase.h"

namespace cellsweep {

/// Does the checks of Broadphase's three input calls, makes boxes canonical and turns ids into slots. An
/// engine derives from it and only ever sees good input.
class CheckedBroadphase : public Broadphase {
 public:
  using Broadphase::insert;
  using Broadphase::move;
  using Broadphase::remove;
  Status insert(std::span<const BodyId> ids, std::span<const Aabb> boxes) final;
  Status move(std::span<const BodyId> ids, std::span<const Aabb> boxes) final;
  Status remove(std::span<const BodyId> ids) final;
  Status insert_poses(std::span<const BodyId> ids, std::span<const BodyPose> poses) final;
  Status move_poses(std::span<const BodyId> ids, std::span<const BodyPose> poses) final;
  std::size_t size() const final { return bodies_.size(); }

 protected:
  /// New bodies; a slot may be one that a removed body left.
  virtual void apply_insert(std::span<const Slot> slots, std::span<const Aabb> boxes) = 0;
  virtual void apply_move(std::span<const Slot> slots, std::span<const Aabb> boxes) = 0;
  /// Called while the bodies are still in the table.
  virtual void apply_remove(std::span<const Slot> slots) = 0;

  /// True for an engine that makes boxes from poses; only such a one gets any.
  virtual bool takes_poses() const { return false; }
  virtual void apply_insert_poses(std::span<const Slot>, std::span<const BodyPose>) {}
  virtual void apply_move_poses(std::span<const Slot>, std::span<const BodyPose>) {}

  const BodyTable& bodies() const { return bodies_; }

 private:
  template <class Shape>
  Status check_shapes(std::span<const BodyId> ids, std::span<const Shape> shapes,
                      std::vector<Shape>& checked);
  Status make_slots(std::span<const BodyId> ids);
  Status find_slots(std::span<const BodyId> ids);
  Status check_room(std::size_t more) const;

  BodyTable bodies_;
  std::vector<Slot> slots_;  // of the call that is being applied
  std::vector<Aabb> boxes_;  // its boxes, canonical
  std::vector<BodyPose> poses_;
};

}  // namespace cellsweep
