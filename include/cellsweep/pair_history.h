/// @file
/// What began and ended since an update that is some updates ago.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "cellsweep/broadphase.h"
#include "cellsweep/export.h"
#include "cellsweep/status.h"

namespace cellsweep {

/// Remembers the changes of a Broadphase's updates, for those who look at it less often than it is updated,
/// each at his own pace: a network peer, a script, a display.
///
/// Updates have numbers that ascend by one; Statistics::updates after an update is one. The first update that
/// is recorded may have any.
///
/// Memory: at most `most_pairs` changes are remembered, pairs that began and pairs that ended, at 8 bytes
/// each, and 24 bytes for each update that changed anything; at times three times as much. When there would
/// be more, the oldest updates are forgotten, each as a whole.
///
/// Threads: one object belongs to one thread at a time. std::bad_alloc may leave a call, and changes nothing.
class CELLSWEEP_API PairHistory {
 public:
  explicit PairHistory(std::size_t most_pairs);
  /// What was moved from may be assigned to or destroyed, and nothing else.
  PairHistory(PairHistory&& other) noexcept;
  PairHistory& operator=(PairHistory&& other) noexcept;
  ~PairHistory();

  /// After each update, what it returned. Errors: bad_input for a number that is not the last one and 1; one
  /// who left an update out begins with a new history.
  Status record(std::uint64_t update_number, const PairChanges& changes);

  /// What changed since an update, as if that and the last one recorded had followed each other: `ended` are
  /// pairs that overlapped then and ceased to at some update since, `began` those that overlap now and began
  /// to at some update since. A pair that broke and formed again, or whose body was made anew, is in both;
  /// one that began and ended in between is in neither. Ascending; valid until the next call of record() or
  /// since(). The cost follows the changes since. Errors: capacity for an update that is forgotten, or older
  /// than the first that was recorded: `number` was asked for, `limit` is the oldest that is there; bad_input
  /// for one that is not recorded yet.
  Result<PairChanges> since(std::uint64_t update_number);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace cellsweep
