/// @file
/// Any bytes taken for a sequence of calls on engine `stream`, each answer compared with all against all.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace cellsweep::fuzz {

/// What became of a sequence.
struct CallsOutcome {
  std::string story;          ///< which settings the engine had
  std::uint64_t updates = 0;  ///< each compared with the oracle
  std::uint64_t pairs = 0;    ///< of the oracle, summed over the updates
  std::string failure{};      ///< what was wrong; empty where nothing was
};

/// Makes the calls. Every sequence of bytes has a meaning, the same at each time: the first byte is the
/// engine's settings, the second the ids and the number of bodies, each one behind them a call, followed by
/// what the call needs; where bytes end in the middle of a call, zeros follow. One of the calls is the end,
/// and bytes behind it mean nothing.
CallsOutcome make_calls(std::span<const std::uint8_t> bytes);

}  // namespace cellsweep::fuzz
