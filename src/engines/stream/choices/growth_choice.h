/// @file
/// How far the fat boxes of slow bodies reach, and of those that tremble.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "base/tuning.h"
#include "engines/stream/bodies/growth.h"
#include "engines/stream/choices/fat_box_work.h"

namespace cellsweep::stream {

/// Where nearly all candidates are pairs, as in stacks that rest on nothing but each other, fat boxes may
/// reach further: that adds next to no candidates, and they last longer. Where candidates that are no pairs
/// cost more than fat boxes that are left, as in crates that tremble side by side, those of bodies that
/// tremble reach hardly further than these were seen to move. What had to be taken back is tried less soon
/// again.
class GrowthChoice {
 public:
  /// That of the next update.
  const Growth& growth() const { return kGrowths[kind_]; }

  /// An update with fat boxes has ended, in which most bodies moved and all candidates were looked at, or
  /// few.
  void note(const FatBoxWork& work, bool most_move) {
    const bool are_few = work.candidates <= work.pairs + work.pairs / tuning::kPairsOfSpareCandidate;
    if (are_few && pause_ > 0) --pause_;
    if (kind_ == kAmple && !are_few) take_back(kUsual);
    if (most_move) note_lost(work);
    if (kind_ != kAmple && are_few && pause_ == 0) kind_ = kind_ == kTight ? kUsual : kAmple;
  }

 private:
  enum Kind { kTight, kUsual, kAmple };
  static constexpr Growth kGrowths[] = {
      {.updates = tuning::kTightSteps,
       .steps = tuning::kTightSteps,
       .most_halvings = tuning::kTightHalvings,
       .raise = tuning::kTightRaise},
      {},
      {.least = tuning::kAmpleGrowth, .most_halvings = tuning::kAmpleHalvings}};

  // Smaller ones would have to be made more often: what that takes now counts against them.
  void note_lost(const FatBoxWork& work) {
    const std::size_t usual = tuning::kUsualCandidates * work.pairs + work.bodies / 2;
    const std::uint64_t all = tuning::kLooksOfFull * work.bodies;
    const std::uint64_t made = work.is_full ? all : tuning::kLooksOfPlaced * work.placed;
    lost_ += work.candidates > usual ? work.candidates - usual : 0;
    lost_ -= std::min(lost_, made);
    if (kind_ == kTight || lost_ <= all) return;
    take_back(kTight);
    lost_ = 0;
  }

  void take_back(Kind kind) {
    kind_ = kind;
    pause_ = patience_;
    patience_ = std::min(2 * patience_, tuning::kMostPatienceOfGrowth);
  }

  Kind kind_ = kUsual;
  std::uint64_t lost_ = 0;   // in looks at a candidate
  std::uint32_t pause_ = 0;  // updates with few candidates before fat boxes reach further
  std::uint32_t patience_ = tuning::kPatienceOfGrowth;
};

}  // namespace cellsweep::stream
