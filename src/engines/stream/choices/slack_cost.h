/// @file
/// What it has cost that fat boxes are larger than boxes, and whether to make them anew.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "base/tuning.h"

namespace cellsweep::stream {

/// Fat boxes that once had to reach far are kept for as long as they last, and those of a pile that comes to
/// rest last for good: with candidates in them that are no pairs and are looked at in every update. Once that
/// has cost as much as it takes to make all of them anew, a few times over, they are made anew; less soon
/// again where that was of no use. Counted in looks at a candidate.
class SlackCost {
 public:
  /// An update has looked at all candidates.
  void note(std::size_t candidates, std::size_t pairs) {
    const std::size_t few = pairs + pairs / 2;
    lost_ += candidates > few ? candidates - few : 0;
    if (++age_ == tuning::kUpdatesToRefit) learn(candidates);
  }

  /// Whether fat boxes are to be made anew in this update.
  bool is_high(std::size_t bodies, std::size_t candidates) const {
    const std::uint64_t price = tuning::kLooksOfFull * bodies + tuning::kLooksOfCandidate * candidates;
    return lost_ > tuning::kPricesOfRefit * patience_ * price;
  }

  /// All fat boxes were made anew, because it was high when there were so many candidates, or for another
  /// reason.
  void note_refit(std::size_t candidates) {
    note_made();
    before_ = candidates;
  }
  void note_made() {
    lost_ = 0;
    age_ = 0;
    before_ = 0;
  }

 private:
  // Whether the last time was of use.
  void learn(std::size_t candidates) {
    if (before_ == 0) return;
    const bool was_of_use = candidates < before_ - before_ / 4;
    patience_ = was_of_use ? 1 : std::min(2 * patience_, tuning::kMostPatienceOfRefit);
    before_ = 0;
  }

  std::uint64_t lost_ = 0;
  std::uint64_t patience_ = 1;
  std::uint32_t age_ = 0;   // updates since they were made
  std::size_t before_ = 0;  // candidates when they were made because it was high; 0: not so
};

}  // namespace cellsweep::stream
