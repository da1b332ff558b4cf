/// @file
/// The pairs of a few bodies before and after they changed: asked of the cells, so that no list of all
/// candidates is walked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/array.h"
#include "base/threads/crew.h"
#include "cellsweep/engine/engine.h"
#include "engines/stream/cells/cell_tree.h"
#include "engines/stream/cells/keys.h"
#include "engines/stream/pairs/candidate_list.h"

namespace cellsweep::stream {

/// One body after the other is asked for, once by the fat box that it had, and once, when the cells hold
/// that, by the one that it has: its box lay in the first, and lies in the second. A pair of two that changed
/// is listed with the first one of them that is asked for as it was before, and with the last one as it is
/// now.
class PairsOfFew {
 public:
  /// By slot.
  enum Mark : std::uint8_t { kUnchanged, kChanged, kAsked };

  /// The bodies of `changes`, which stay there, are marked as changed.
  void begin(const BodyChanges& changes, const std::uint8_t* marks);

  /// The candidates that a body had, and those that it has: pairs with all whose fat boxes in the cells
  /// overlap this one. Valid until the next call. After that the body is to be marked as asked for.
  std::span<const std::uint64_t> had(CellTree& cells, Slot slot, const Aabb& fat_box);
  std::span<const std::uint64_t> has(CellTree& cells, Slot slot, const Aabb& fat_box);
  /// Both of a body that stayed in its fat box.
  void stayed(CellTree& cells, Slot slot, const Aabb& fat_box);

  /// What differs. Valid until the next call.
  SlotPairChanges changes(Crew& crew);

  [[gnu::cold]] std::size_t bytes() const;

 private:
  void find_candidates(CellTree& cells, Slot slot, const Aabb& fat_box);
  void list_before(Slot slot);
  void list_now(Slot slot);
  template <class BoxOf>
  void list(Slot slot, std::uint8_t left_out, const BoxOf& box_of, Keys& pairs) const;
  static void sort(Crew& crew, const Keys& keys, Array<std::uint64_t>& scratch, Array<SlotPair>& pairs);

  const BodyChanges* bodies_ = nullptr;  // from begin() on
  const std::uint8_t* marks_ = nullptr;
  Keys partners_;    // of one body
  Keys candidates_;  // with these
  Keys keys_before_;
  Keys keys_now_;
  Array<std::uint64_t> scratch_;
  Array<SlotPair> before_;
  Array<SlotPair> now_;
  Array<SlotPair> began_;
  Array<SlotPair> ended_;
};

}  // namespace cellsweep::stream
