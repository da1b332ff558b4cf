/// @file
/// What updates of engine `stream` take, learnt from those before, and what follows for the next.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>

#include "base/tuning.h"

namespace cellsweep::stream {

/// What one kind of update takes for each body that it handles, in seconds of one thread.
class Cost {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Cost(double first_guess) : seconds_(first_guess) {}

  double seconds() const { return seconds_; }

  /// An update of so many bodies took so long. One late thread must not change a plan.
  void learn(Clock::duration elapsed, unsigned workers, std::size_t bodies) {
    const double seconds = std::chrono::duration<double>(elapsed).count();
    const double sample = seconds * workers / static_cast<double>(bodies);
    seconds_ += 0.25 * (std::clamp(sample, seconds_ / 4, seconds_ * 2) - seconds_);
  }

 private:
  double seconds_;
};

/// Of a body when everything is found anew, and of one whose fat box changed.
struct Costs {
  Cost full{tuning::kFullGuess};
  Cost partial{tuning::kPartialGuess};

  /// Up to how many changes of fat boxes an update would rather look at one by one.
  std::size_t most_listed(std::size_t bodies) const {
    const double share =
        std::clamp(full.seconds() / partial.seconds(), tuning::kLeastShare, tuning::kMostShare);
    return static_cast<std::size_t>(static_cast<double>(bodies) * share);
  }
};

}  // namespace cellsweep::stream
