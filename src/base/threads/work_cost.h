/// @file
/// What a kind of work takes, learnt from how long it took before, and by how many workers it is done.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>

#include "base/tuning.h"

namespace cellsweep {

/// What one item of a kind of work takes: by one worker, and by all of them together. Which is less, no
/// measurement of a dispatch tells: the other threads may sleep, and what they read lies in the caches of the
/// caller. So the other way is tried now and then, the less often the longer it has been the slower one.
class WorkCost {
 public:
  using Clock = std::chrono::steady_clock;

  /// `first_guess` is in seconds of one worker.
  explicit WorkCost(double first_guess) : mean_(first_guess) {}

  /// Of an item, by one worker.
  double seconds() const { return mean_; }

  /// Whether the next work is to be done by all workers, where they are worth their dispatch.
  bool by_all() const { return by_all_; }

  /// So many items took so long. Not inlined, for the size of programs.
  [[gnu::noinline]] void learn(std::chrono::duration<double> elapsed, unsigned workers, std::size_t items);

 private:
  void note_turn(double sample);
  void begin_trial(bool by_all);
  void end_trial();

  double mean_;                  // seconds of an item, by one worker
  double alone_ = 0;             // the least that it took of late, by one; what delays one delays by chance
  double together_ = 0;          // and by all
  bool is_alone_known_ = false;  // not only by what all took
  bool by_all_ = true;           // the next work
  bool is_trial_ = true;         // which is done the other way than usual, or for the first time
  std::uint32_t turns_ = 0;      // since the last trial began, or ended
  std::uint32_t patience_ = tuning::kLeastTurns;
};

}  // namespace cellsweep
