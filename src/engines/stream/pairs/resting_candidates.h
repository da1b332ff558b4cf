/// @file
/// Candidates of two bodies that rest: no update walks them while nobody of theirs moves.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/memory/array.h"
#include "base/memory/list.h"
#include "base/tuning.h"
#include "cellsweep/engine/slots.h"

namespace cellsweep {
struct BodyChanges;
}  // namespace cellsweep

namespace cellsweep::stream {

/// Candidates and, for each, a mark whether they overlap: OverlapMarks.
struct MarkedCandidates {
  Array<SlotPair>& pairs;
  Array<std::uint8_t>& marks;
};

/// Where few bodies move, the same ones for many updates, most candidates are of two that rest. These are
/// parted from the others once nobody has begun to move for some updates, and are reunited with them when
/// somebody of theirs moves or is taken out, or when all are asked for.
class RestingCandidates {
 public:
  /// An update begins in which few bodies change. True when one of them rested: all are to be reunited.
  bool begin_update(const BodyChanges& changes);
  /// Whether enough updates have told who rests: they may be parted.
  bool are_known() const { return !are_parted() && calm_ >= patience_; }

  /// Takes out those that rest, if these are most.
  [[gnu::cold]] void part(const MarkedCandidates& all);
  /// Puts them back, in ascending order.
  [[gnu::cold]] void reunite(const MarkedCandidates& others);

  bool are_parted() const { return are_parted_; }
  std::size_t size() const { return pairs_.size(); }
  std::size_t bytes() const { return pairs_.bytes() + marks_.bytes() + awake_.bytes(); }

 private:
  bool rest(const SlotPair& pair) const { return (awake_[pair.a] | awake_[pair.b]) == 0; }
  bool wake(Slot slot);
  void begin_anew(std::uint32_t patience);

  Array<SlotPair> pairs_;
  Array<std::uint8_t> marks_;
  List<std::uint8_t> awake_;  // by slot: it has moved, come or gone
  bool are_parted_ = false;
  std::uint32_t calm_ = 0;  // updates in which nobody else did, or since they were parted
  std::uint32_t patience_ = tuning::kPatienceToPart;  // after so many of the first kind they may be
};

}  // namespace cellsweep::stream
