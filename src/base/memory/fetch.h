/// @file
/// Memory that will be needed soon.
#pragma once

#include <cstddef>

namespace cellsweep {

/// Asks for the cache lines of so many bytes, which will be written to. In line, as what asks for memory is
/// to be: GCC sees that such a function changes nothing, and leaves out its calls.
[[gnu::always_inline]] inline void fetch(const void* memory, std::size_t bytes) {
  constexpr std::size_t kLine = 64;
  const auto* const first = static_cast<const std::byte*>(memory);
  for (std::size_t at = 0; at < bytes; at += kLine) __builtin_prefetch(first + at, 1);
}

}  // namespace cellsweep
