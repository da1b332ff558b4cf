/// @file
/// What the soak does over and over: the whole life of an engine on a random world, told by one number.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cellsweep::soak {

/// How a life went.
struct Outcome {
  std::string story;          ///< which engine, which world
  std::uint64_t updates = 0;  ///< each compared with all against all
  std::uint64_t pairs = 0;    ///< of the oracle, summed over the updates
  std::string failure{};      ///< what was wrong; empty where nothing was
};

/// Random calls on a kind of boxes, with questions between them or none, or frames of a scene, on any engine
/// with any settings that the contract suite knows; or bytes taken for calls on `stream`. The same seed lives
/// the same life. With a name only engines of that name are taken, which must be one that the contract suite
/// has (is_engine()).
Outcome live(std::uint64_t seed, std::string_view only = {});

bool is_engine(std::string_view name);

}  // namespace cellsweep::soak
