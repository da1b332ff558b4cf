/// @file
/// When engine `stream` gives memory back.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/tuning.h"

namespace cellsweep::stream {

/// Memory is spare that is of no use while few bodies move: it goes back when they have for some updates. And
/// so it does when more is held than pairs and bodies account for. What the last update found lies in it,
/// which is why it waits for the next.
class SpareMemory {
 public:
  /// An update begins. Whether memory is to go back.
  bool begin_update() {
    const bool is_quiet = is_spare_ && ++quiet_ > tuning::kQuietToGiveBack;
    return (is_quiet && bytes_ > tuning::kFewBytes) || is_too_much_;
  }

  /// An update needs what is of no use while few bodies move.
  void note_used() {
    is_spare_ = true;
    quiet_ = 0;
  }
  /// It is about to go back; where that fails, it is tried again after as many updates.
  void note_tried() { quiet_ = 0; }
  void note_given_back() { is_spare_ = false; }

  /// Whether it is time to sum up what is held, which reads two dozen lines of the caches: an update of a few
  /// holds hardly more than the one before, but many pairs may have ended one by one.
  bool is_to_count(bool is_of_few, std::size_t pairs) const { return !is_of_few || 2 * pairs < pairs_; }
  /// So much is held for so many pairs, and more than `most` is too much.
  void count(std::size_t bytes, std::size_t most, std::size_t pairs) {
    bytes_ = bytes;
    pairs_ = pairs;
    is_too_much_ = bytes > most;
  }

 private:
  std::size_t bytes_ = 0;  // as counted last,
  std::size_t pairs_ = 0;  // with so many pairs
  bool is_too_much_ = false;
  bool is_spare_ = false;
  std::uint32_t quiet_ = 0;  // updates since it was used
};

}  // namespace cellsweep::stream
