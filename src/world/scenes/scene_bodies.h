/// @file
/// The bodies of a scripted scene, and what a frame did to them.
#pragma once

#include <cassert>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/pair.h"

namespace cellsweep {

/// Boxes by id, who is there, and the changes of the frame, as a FrameSource hands them out. A script names
/// bodies in ascending order within a frame, and a body in one way only. A giant stays as it was inserted.
class SceneBodies {
 public:
  SceneBodies(std::size_t bodies, std::optional<BodyId> giant, const Aabb& giant_box);

  /// A new frame, in which nothing has changed yet.
  void begin_frame();
  /// Brings bodies() up to date.
  void end_frame();

  void insert(BodyId id, const Aabb& box);
  void remove(BodyId id);
  /// Noted as moved if the box is another one.
  void move(BodyId id, const Aabb& box);

  bool has(BodyId id) const { return has_[id] != 0; }

  std::span<const Aabb> boxes() const { return boxes_; }
  std::span<const BodyId> bodies() const { return bodies_; }
  std::span<const BodyId> moved() const { return moved_; }
  std::span<const BodyId> inserted() const { return inserted_; }
  std::span<const BodyId> removed() const { return removed_; }

 private:
  std::optional<BodyId> giant_;
  std::vector<Aabb> boxes_;
  std::vector<char> has_;
  std::vector<BodyId> bodies_;
  std::vector<BodyId> moved_;
  std::vector<BodyId> inserted_;
  std::vector<BodyId> removed_;
};

}  // namespace cellsweep
