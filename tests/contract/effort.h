/// @file
/// How much the contract suite does: the whole; fewer repetitions of the longest parts in a build with
/// sanitizers, several times slower and made twice; or, where an emulator executes every instruction, a part
/// that still has every engine, kind of boxes and scene.
#pragma once

namespace cellsweep::contract {

enum class Pace { plain, sanitized, emulated };

#if defined(CELLSWEEP_EMULATED_TESTS)
inline constexpr Pace kPace = Pace::emulated;
#elif defined(CELLSWEEP_SANITIZED_TESTS)
inline constexpr Pace kPace = Pace::sanitized;
#else
inline constexpr Pace kPace = Pace::plain;
#endif

inline constexpr bool kEmulated = kPace == Pace::emulated;

/// The number of times to do something.
constexpr auto effort(auto whole, decltype(whole) sanitized, decltype(whole) emulated) {
  if (kEmulated) return emulated;
  return kPace == Pace::sanitized ? sanitized : whole;
}

/// The same with sanitizers as without.
constexpr auto effort(auto whole, decltype(whole) emulated) {
  return effort(whole, whole, emulated);
}

}  // namespace cellsweep::contract
