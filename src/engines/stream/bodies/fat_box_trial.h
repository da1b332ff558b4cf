/// @file
/// How long fat boxes would last, as those of a few bodies tell.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "base/threads/crew.h"
#include "base/tuning.h"
#include "cellsweep/engine/engine.h"
#include "engines/stream/bodies/fat_boxes.h"

namespace cellsweep::stream {

/// A few bodies have fat boxes while the others have none.
class FatBoxTrial {
 public:
  /// Chooses bodies among those that move in this update.
  [[gnu::cold]] void begin(const BodyChanges& changes);

  /// Goes on with an update that follows. False when one of them is not there any more: then begin() is to
  /// follow.
  [[gnu::cold]] bool go_on(Crew& crew, const BodyChanges& changes);

  /// Updates since begin().
  std::uint32_t updates() const { return updates_; }
  /// The share of them that left their fat boxes in an update, in the mean; of the first ones, that made
  /// these, nothing counts.
  [[gnu::cold]] double share_escaped() const;

 private:
  static constexpr std::uint32_t kSettling = 4;

  std::size_t count_ = 0;
  std::uint32_t updates_ = 0;
  std::size_t escaped_ = 0;
  std::array<Slot, tuning::kTried> slots_{};
  std::array<Aabb, tuning::kTried> boxes_{};
  FatBoxes fat_boxes_;
};

}  // namespace cellsweep::stream
