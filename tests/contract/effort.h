/// @file
/// How much the contract suite does: the whole; fewer repetitions of the longest parts in a build with
/// sanitizers, several times slower and made twice; or, where an emulator executes every instruction, a part
/// that still has every engine, kind of boxes and scene. Besides, what the gate does once the long form of
/// the tests (`./test --long`) repeats.
#pragma once

#include <cstddef>
#include <cstdlib>

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

/// Whether these are the tests' long form.
inline bool is_long() {
  static const bool set = std::getenv("CELLSWEEP_LONG_TESTS") != nullptr;
  return set;
}

/// The number of times to do again, on other numbers, what the gate has done: `times` in the long form.
template <class Number>
Number repeated(Number times, Number in_gate = 1) {
  return is_long() ? times : in_gate;
}

/// Whether it is the turn of this one of several cases that need not all meet every kind of boxes: in the
/// gate, with sanitizers, each kind does a third of them, and an engine all of them by the time that it has
/// met all kinds.
inline bool is_turn(std::size_t number, std::size_t turn) {
  return is_long() || (number + turn) % effort(1U, 3U, 1U) == 0;
}

}  // namespace cellsweep::contract
