/// @file
/// How much the contract suite does: the whole, or, where an emulator executes every instruction, a part that
/// still has every engine, kind of boxes and scene.
#pragma once

namespace cellsweep::contract {

#if defined(CELLSWEEP_EMULATED_TESTS)
inline constexpr bool kEmulated = true;
#else
inline constexpr bool kEmulated = false;
#endif

/// The number of times to do something.
constexpr auto effort(auto whole, decltype(whole) emulated) {
  return kEmulated ? emulated : whole;
}

}  // namespace cellsweep::contract
