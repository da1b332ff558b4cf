/// @file
/// Which of the candidates of engine `stream` overlap: those whose hulls do, tested by their boxes.
#pragma once

#include <cstdint>
#include <span>

#include "cellsweep/broadphase.h"
#include "broadphase/bodies/id_table.h"
#include "engines/stream/kernels/kernel.h"
#include "base/memory/array.h"
#include "engines/stream/pool.h"

namespace cellsweep::stream {

/// The boxes to test, by slot.
struct TestedBoxes {
  const Aabb* boxes;
  const IdTable& table;
  /// By slot: whether the box is new since the last test, as a number equal to `is_new`; null to test all.
  const std::uint8_t* stamps = nullptr;
  std::uint8_t is_new = 0;
};

/// The candidates that overlap, ascending. For each candidate a mark says whether it did at the last test. A
/// call that runs out of memory, or throws TooManyPairs because more than `most` overlap, leaves all as it
/// was.
class OverlapList {
 public:
  /// All candidates overlap, and did before.
  void start(std::span<const Pair> candidates);

  /// Tests all candidates, which may be others than before.
  PairChanges renew(Pool& pool, std::span<const Pair> candidates, const TestedBoxes& tested,
                    std::size_t most);

  /// Tests candidates that differ from those before by `changes`.
  PairChanges refresh(Pool& pool, std::span<const Pair> candidates, const PairChanges& changes,
                      const TestedBoxes& tested, std::size_t most);

  std::span<const Pair> pairs() const { return pairs_.view(); }

  /// Bytes held.
  std::size_t bytes() const;

 private:
  void make_room(std::size_t candidates, std::size_t ended);

  Array<Pair> pairs_;
  Array<std::uint8_t> marks_;
  Array<Pair> spare_;  // room for the next
  Array<std::uint8_t> spare_marks_;
  Array<Pair> began_;
  Array<Pair> ended_;
};

}  // namespace cellsweep::stream
