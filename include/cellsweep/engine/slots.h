/// @file
/// Slots: what engines know of bodies in the place of their ids.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "cellsweep/aabb.h"

namespace cellsweep {

/// A body's place: a small number that Broadphase gives it for as long as it is there.
using Slot = std::uint32_t;
inline constexpr Slot kNoSlot = std::numeric_limits<Slot>::max();

/// The bits of a slot: there are never more of them.
inline constexpr unsigned kSlotBits = 29;
inline constexpr Slot kSlotMask = (1U << kSlotBits) - 1;

/// The box in a slot without a body: NaN, so that it overlaps nothing.
inline constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();
inline constexpr Aabb kNobody = {{kNowhere, kNowhere, kNowhere}, {kNowhere, kNowhere, kNowhere}};

/// So many consecutive slots are a block.
inline constexpr std::size_t kSlotBlock = 64;

/// Boxes of some slots, to read: by slot, or in blocks. Of other slots there may be none.
class SlotBoxes {
 public:
  SlotBoxes() = default;
  SlotBoxes(std::span<const Aabb> by_slot) : by_slot_(by_slot.data()) {}
  /// The boxes of each block, those that are asked for; null for boxes by slot.
  SlotBoxes(const Aabb* const* blocks, const Aabb* by_slot) : blocks_(blocks), by_slot_(by_slot) {}

  const Aabb& operator[](Slot slot) const {
    return blocks_ == nullptr ? by_slot_[slot] : blocks_[slot / kSlotBlock][slot % kSlotBlock];
  }

 private:
  const Aabb* const* blocks_ = nullptr;
  const Aabb* by_slot_ = nullptr;
};

/// Two slots, `a < b`.
struct SlotPair {
  Slot a = 0;
  Slot b = 0;

  // NOLINTNEXTLINE(modernize-use-nullptr): the comparison that is generated has no pointer in it.
  friend auto operator<=>(const SlotPair&, const SlotPair&) = default;
};

constexpr SlotPair make_slot_pair(Slot one, Slot other) {
  return one < other ? SlotPair{one, other} : SlotPair{other, one};
}

/// `(a << 32) | b`.
constexpr std::uint64_t pair_key(SlotPair pair) {
  return (std::uint64_t{pair.a} << 32) | pair.b;
}

}  // namespace cellsweep
