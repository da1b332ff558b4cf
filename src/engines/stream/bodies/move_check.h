/// @file
/// The checks of a move() of engine `stream`: which boxes are refused, which differ, which leave their hulls.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "cellsweep/aabb.h"
#include "geometry/box_lanes.h"
#include "broadphase/bodies/id_table.h"
#include "engines/stream/pairs/pair_list.h"
#include "engines/stream/pool.h"

namespace cellsweep::stream {

/// A body whose new box is not the one it has.
struct MovedBody {
  std::uint32_t index = 0;  // in the call
  std::uint32_t slot = 0;
  bool escapes = false;  // its hull
};

/// What the bodies have now, by slot.
struct HeldBoxes {
  const IdTable& table;
  std::span<const Aabb> boxes;
  const Aabb* hulls;
};

/// What one worker finds out about its share of a call. Reads what is held and changes nothing.
class MoveCheck {
 public:
  void run(const HeldBoxes& held, std::span<const BodyId> ids, std::span<const Aabb> boxes, Share share);

  /// No id is unknown, no box invalid. When false, the rest means nothing.
  bool good() const { return good_; }
  /// Every box is canonical as it is.
  bool clean() const { return clean_; }
  std::size_t escapes() const { return escapes_; }
  std::span<const MovedBody> moved() const { return {list_.data(), count_}; }

  std::size_t bytes() const { return list_.bytes(); }
  void give_back() { list_ = {}; }

 private:
  std::uint32_t find(const HeldBoxes& held, BodyId id);
  void check_block(const HeldBoxes& held, const std::uint32_t* slots, std::span<const Aabb> boxes,
                   std::size_t first);
  void note(const HeldBoxes& held, std::uint32_t slot, const BoxLanes& box, std::size_t index);

  bool good_ = true;
  bool clean_ = true;
  Array<MovedBody> list_;
  std::size_t count_ = 0;
  std::size_t escapes_ = 0;
};

/// True when every box is valid and canonical as it is.
bool are_clean(std::span<const Aabb> boxes);

}  // namespace cellsweep::stream
