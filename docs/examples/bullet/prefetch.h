/// @file
/// Memory that a step has put out of the caches is asked for before it is needed.
#pragma once

#include <cstddef>

/// Asks for all of an object that will be written soon, where the compiler knows how.
template <class Object>
void prefetch(const Object& object) {
#ifdef __GNUC__
  constexpr std::size_t kLine = 64;
  const char* const memory = reinterpret_cast<const char*>(&object);
  for (std::size_t i = 0; i < sizeof object; i += kLine) __builtin_prefetch(memory + i, 1);
#endif
}
