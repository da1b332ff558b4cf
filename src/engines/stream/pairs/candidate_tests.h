/// @file
/// Tests candidates by their boxes, and says which began and ended to overlap.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/threads/crew.h"
#include "base/tuning.h"
#include "cellsweep/engine/slots.h"
#include "engines/stream/pairs/candidate_list.h"

namespace cellsweep::stream {

/// The boxes to test, by slot.
struct TestedBoxes {
  const Aabb* boxes = nullptr;
  /// By slot: not 0 where the box is new since the last test; null to test all.
  const std::uint8_t* fresh = nullptr;
};

/// Where a worker writes, and how far it got. There is room for a mark and a pair that began for each of its
/// candidates, and for a pair that ended for each of these and of those that ended before or among them.
struct TestOutput {
  std::uint8_t* marks;
  SlotPair* began;
  SlotPair* ended;
};

/// A test of candidates that differ from those of the last test by `changes`.
struct CandidateTest {
  std::span<const SlotPair> candidates;
  SlotPairChanges changes;
  const std::uint8_t* old_marks = nullptr;  ///< of the candidates before: whether they overlapped
  TestedBoxes tested;
};

/// Tests a share of the candidates, which is not empty. The marks may be written over the old ones where no
/// candidate began or ended.
void test_share(const CandidateTest& test, const Share& share, TestOutput& output);

/// Whether the boxes of these overlap, as marks.
void mark_overlaps(std::span<const SlotPair> candidates, const Aabb* boxes, std::uint8_t* marks);

/// Asks for the box of a candidate that will be tested soon.
inline void prefetch_box(std::span<const SlotPair> candidates, std::size_t i, const Aabb* boxes) {
  const std::size_t ahead = i + tuning::kAhead;
  __builtin_prefetch(&boxes[candidates[ahead < candidates.size() ? ahead : candidates.size() - 1].b]);
}

}  // namespace cellsweep::stream
