/// @file
/// Slots: what engines know of bodies in the place of their ids.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>

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
