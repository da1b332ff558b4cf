/// @file
/// Which of the candidates of engine `stream` overlap: those whose fat boxes do, tested by their boxes.
#pragma once

#include <cstdint>
#include <span>
#include <utility>

#include "base/memory/array.h"
#include "base/threads/crew.h"
#include "cellsweep/engine/slots.h"
#include "engines/stream/pairs/candidate_list.h"
#include "engines/stream/pairs/candidate_tests.h"
#include "engines/stream/pairs/pair_room.h"

namespace cellsweep::stream {

/// Boxes as they were at the last test, by slot.
struct BoxesBefore {
  const Aabb* boxes = nullptr;          ///< as they are now
  SlotBoxes before;                     ///< of the bodies that changed
  const std::uint8_t* fresh = nullptr;  ///< not 0 of those
};

/// A mark for each candidate, whether it overlapped at the last test. What began and ended is written to a
/// room, and is there until somebody else writes to it.
class OverlapMarks {
 public:
  /// All candidates, so many, overlap.
  void mark_all(std::size_t candidates);

  /// Tests all candidates, which may be others than before; nothing is known of them.
  void test_all(Crew& crew, std::span<const SlotPair> candidates, const Aabb* boxes);
  void test_all(Crew& crew, std::span<const SlotPair> candidates, const BoxesBefore& boxes);

  /// Tests candidates that differ from those before by `changes`, and says which began and ended to overlap.
  SlotPairChanges refresh(Crew& crew, std::span<const SlotPair> candidates, const SlotPairChanges& changes,
                          const TestedBoxes& tested, PairRoom& room);

  /// Those of all candidates, in their order, to be changed together with these.
  Array<std::uint8_t>& all() { return marks_; }

  /// Leaves the marked ones in the list of all candidates.
  void leave_marked(Array<SlotPair>& candidates) const;

  /// What differs between the pairs that overlapped before and the marked ones of the candidates now.
  SlotPairChanges compare(std::span<const SlotPair> before, std::span<const SlotPair> now,
                          PairRoom& room) const;

  /// Gives memory back that the next call may ask for again.
  [[gnu::cold]] void give_back();

  /// Bytes held.
  std::size_t bytes() const;

 private:
  template <class Mark>
  void mark(Crew& crew, std::span<const SlotPair> candidates, Mark&& mark);

  Array<std::uint8_t> marks_;
  Array<std::uint8_t> spare_;  // room for the next
};

}  // namespace cellsweep::stream
