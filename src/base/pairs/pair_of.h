/// @file
/// Back from pair_key() to the pair.
#pragma once

#include <cstdint>

namespace cellsweep {

/// `AnyPair` is Pair or SlotPair.
template <class AnyPair>
constexpr AnyPair pair_of(std::uint64_t key) {
  return {static_cast<std::uint32_t>(key >> 32), static_cast<std::uint32_t>(key)};
}

}  // namespace cellsweep
