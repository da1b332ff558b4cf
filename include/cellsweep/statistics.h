/// @file
/// What a broadphase measured and counted.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace cellsweep {

enum class PhaseKind {
  work,   ///< of the frame, on the host
  setup,  ///< done once per body ever inserted; reports show it apart from the frame (the pair map, X1)
  spes    ///< of the frame, while the SPEs of a Cell engine work
};

/// The time that one step of the last update() took.
struct Phase {
  std::string_view name;
  double milliseconds = 0;
  PhaseKind kind = PhaseKind::work;
};

/// A number that an engine counts, over its whole life unless the name says otherwise. For people to read.
struct Counter {
  std::string_view name;
  std::uint64_t value = 0;
};

/// What an engine did over its whole life, counted, not timed. Pairs are the same on every machine, this need
/// not be: `stream` chooses between two ways to the same pairs by what earlier updates took. 0 where an
/// engine does not count.
struct Work {
  std::uint64_t boxes_placed = 0;    ///< put into cells, or what the engine has in their place
  std::uint64_t boxes_compared = 0;  ///< pairs of boxes that were held against each other

  friend Work operator-(const Work& now, const Work& before) {
    return {now.boxes_placed - before.boxes_placed, now.boxes_compared - before.boxes_compared};
  }
};

/// Names are stable within an engine.
struct Statistics {
  std::uint64_t updates = 0;    ///< that succeeded
  std::uint64_t bytes = 0;      ///< of memory held after the last update(), nearly
  std::vector<Phase> phases{};  ///< of the last update(), in the order they ran
  std::vector<Counter> counters{};
  Work work{};
};

}  // namespace cellsweep
