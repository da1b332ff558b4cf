/// @file
/// The pairs of a few bodies before and after they changed: asked of the cells, so that no list of all
/// candidates is walked.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/crew.h"
#include "base/memory/array.h"
#include "cellsweep/engine/engine.h"
#include "engines/stream/cells/cell_tree.h"
#include "engines/stream/cells/keys.h"
#include "engines/stream/pairs/candidate_list.h"

namespace cellsweep::stream {

class PairsOfFew {
 public:
  /// The pairs that the removed and the moved bodies had; the cells hold the fat boxes of that time. `fresh`
  /// is, by slot, not 0 for all that changed.
  void ask_before(CellTree& cells, const BodyChanges& changes, const std::uint8_t* fresh);

  /// The pairs that the moved and the inserted bodies have; the cells hold the fat boxes of now.
  void ask_now(CellTree& cells, const BodyChanges& changes, const std::uint8_t* fresh);

  /// The pairs of a body with the bodies whose boxes in the cells overlap this one, valid until the next
  /// call.
  std::span<const std::uint64_t> partners(CellTree& cells, std::span<const BodyFilter> filters, Slot slot,
                                          const Aabb& box);

  /// What differs. Valid until the next call.
  SlotPairChanges changes(Crew& crew);

  std::size_t bytes() const;

 private:
  template <class BoxOf>
  void ask(CellTree& cells, const BodyChanges& changes, std::span<const Slot> slots,
           const std::uint8_t* fresh, const BoxOf& box_of, Keys& pairs);
  static void sort(Crew& crew, const Keys& keys, Array<std::uint64_t>& scratch, Array<SlotPair>& pairs);

  Keys partners_;  // of one body
  Keys pairs_;     // with these
  Keys keys_before_;
  Keys keys_now_;
  Array<std::uint64_t> scratch_;
  Array<SlotPair> before_;
  Array<SlotPair> now_;
  Array<SlotPair> began_;
  Array<SlotPair> ended_;
};

}  // namespace cellsweep::stream
