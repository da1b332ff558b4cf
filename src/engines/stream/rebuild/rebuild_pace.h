/// @file
/// How far a rebuild is to be after each of its updates.
#pragma once

#include <array>
#include <cstdint>

#include "base/tuning.h"

namespace cellsweep::stream {

/// Updates that have a part of a rebuild each are to take as long as each other, though they have more to do
/// besides the older fat boxes are: what that took in the last rebuilds tells what it will take in the next.
class RebuildPace {
 public:
  /// No part is so many times as long as the mean of all: where there are few of them, each is as long.
  static double most_of_part(std::uint32_t parts) {
    return parts < tuning::kFewParts ? 1 : tuning::kMostOfPart;
  }

  /// A rebuild in so many parts begins, at most tuning::kMostForNext, which will take so many seconds in all;
  /// 0: nobody knows.
  [[gnu::cold]] void begin(std::uint32_t parts, double seconds);

  /// How much of it is due with a part, the first of which is 1: 0 to 1, and 1 with the last one and behind
  /// it.
  double due(std::uint32_t part) const { return part < parts_ ? due_[part] : 1; }

  /// The update with that part took so many seconds besides.
  void note(std::uint32_t part, double seconds);

 private:
  using Parts = std::array<double, tuning::kMostForNext + 1>;

  [[gnu::cold]] double longest_update(double seconds, double most) const;

  std::uint32_t parts_ = 1;
  Parts besides_{};  // in the last updates, by how many parts are left then
  Parts due_{};
};

}  // namespace cellsweep::stream
