/// @file
/// Which bodies may form pairs at all.
#pragma once

#include <cstdint>

namespace cellsweep {

/// What a body is, and what it wants to meet. Two bodies form a pair, when their boxes overlap, only where
/// each one's category has a bit in common with the other's mask, and not both are static. A body that was
/// given none has the default, which meets every other default.
struct BodyFilter {
  std::uint32_t category = 1;        ///< bits: the groups that the body belongs to
  std::uint32_t mask = 0xffffffffU;  ///< bits: the groups that it meets
  bool is_static = false;            ///< level geometry, say: meets no other static body

  friend bool operator==(const BodyFilter&, const BodyFilter&) = default;
};

constexpr bool may_pair(const BodyFilter& one, const BodyFilter& other) {
  return (one.category & other.mask) != 0 && (other.category & one.mask) != 0 &&
         !(one.is_static && other.is_static);
}

}  // namespace cellsweep
