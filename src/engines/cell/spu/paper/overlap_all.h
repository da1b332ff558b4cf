/// @file
/// Step C12, overlap method 2: each changed ID against all others, by value.
#pragma once

#include <cstdint>

#include "engines/cell/wire.h"

namespace cellsweep::cell::paper {

/// Figure 4.8: the ends of an ID in the array in body order, which begins with ID 1.
inline float minimum_of(const float* body_values, std::uint32_t id) {
  return body_values[2 * id - 2];
}
inline float maximum_of(const float* body_values, std::uint32_t id) {
  return body_values[2 * id - 1];
}

/// An ID that no body has now: its place in the array holds a minimum above all values.
inline bool is_vacant(const float* body_values, std::uint32_t id) {
  const float minimum = minimum_of(body_values, id);
  std::uint32_t bits = 0;
  __builtin_memcpy(&bits, &minimum, sizeof bits);
  return bits == kPaddingValueBits;
}

/// Passes to keys.add() the key of every pair of a changed ID and another that overlap on this axis, and to
/// apart.add() the key of every other such pair; each pair once. `changed` is descending and has no
/// duplicates.
template <class Keys>
void test_all(const float* body_values, std::uint32_t largest_id, const std::int32_t* changed,
              std::uint32_t count, Keys& keys, Keys& apart) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto target = static_cast<std::uint32_t>(changed[i]);
    const float minimum = minimum_of(body_values, target);
    const float maximum = maximum_of(body_values, target);
    std::uint32_t next_done = 0;  // larger changed IDs had their turn; they come up in the opposite order
    for (std::uint32_t other = largest_id; other > 0; --other) {
      if (next_done < i && other == static_cast<std::uint32_t>(changed[next_done])) {
        ++next_done;
        continue;
      }
      if (other == target || is_vacant(body_values, other)) continue;
      const bool overlapping =
          minimum <= maximum_of(body_values, other) && minimum_of(body_values, other) <= maximum;
      (overlapping ? keys : apart).add(pair_key_of_ids(target, other));
    }
  }
}

}  // namespace cellsweep::cell::paper
