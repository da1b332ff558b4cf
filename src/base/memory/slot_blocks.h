/// @file
/// What some of many slots have.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/memory/list.h"
#include "base/memory/memory.h"
#include "cellsweep/engine/slots.h"

namespace cellsweep {

/// Something of a trivial type for each slot that needs it. While these are few, memory is taken for blocks
/// of consecutive slots with one of them, and none moves when another is added; once they are many, all lie
/// by slot. What throws std::bad_alloc has changed nothing.
template <class T>
class SlotBlocks {
 public:
  /// Whether so few slots have something that, wherever they are, their blocks take half of the memory that
  /// all slots would.
  static bool suit(std::size_t some, std::size_t slots) { return 2 * kSlotBlock * some <= slots; }

  bool are_by_slot() const { return by_slot_; }

  bool has(Slot slot) const {
    if (by_slot_) return slot < all_.size();
    return slot / kSlotBlock < masks_.size() && (masks_[slot / kSlotBlock] >> slot % kSlotBlock & 1) != 0;
  }
  /// What a slot has.
  T& operator[](Slot slot) { return Places(*this)[slot]; }
  const T& operator[](Slot slot) const { return const_cast<SlotBlocks&>(*this)[slot]; }

  /// Room for so many slots in all, of which so many more get something: add() takes no memory then.
  [[gnu::noinline]] void reserve(std::size_t slots, std::size_t more) {
    const std::size_t blocks = (slots + kSlotBlock - 1) / kSlotBlock;
    const std::size_t most = std::min(used_.size() + more, blocks);
    blocks_.reserve(blocks);
    masks_.reserve(blocks);
    used_.reserve(most);
    while (room_.size() < most) take_chunk(most - room_.size());
    blocks_.resize(std::max(blocks_.size(), blocks), nullptr);
    masks_.resize(std::max(masks_.size(), blocks), 0);
  }
  /// Lets a slot have something, which may be anything. Whether it had nothing.
  bool add(Slot slot) {
    const std::size_t number = slot / kSlotBlock;
    std::uint64_t& mask = masks_[number];
    const std::uint64_t before = mask;
    mask |= std::uint64_t{1} << slot % kSlotBlock;
    if (before == 0) {
      blocks_[number] = room_[used_.size()];
      used_.push(static_cast<std::uint32_t>(number));
    }
    return mask != before;
  }
  /// operator[] for a loop, which would read anew what it holds after each byte that the loop writes.
  class Places {
   public:
    explicit Places(SlotBlocks& held)
        : blocks_(held.by_slot_ ? nullptr : held.blocks_.data()), all_(held.all_.data()) {}

    T& operator[](Slot slot) const {
      return blocks_ == nullptr ? all_[slot] : blocks_[slot / kSlotBlock][slot % kSlotBlock];
    }

   private:
    T* const* blocks_;
    T* all_;
  };

  /// For SlotBoxes: the blocks by number, null where all lie by slot.
  const T* const* blocks() const { return by_slot_ ? nullptr : blocks_.data(); }

  /// No slot has anything. Memory is kept.
  void clear() {
    for (const std::uint32_t number : used_) masks_[number] = 0;
    used_.clear();
  }

  /// All lie by slot from now on: what slots have, and for others what `all` has.
  [[gnu::noinline]] void lay_by_slot(List<T> all) {
    for (const std::uint32_t number : used_) {
      for (std::uint64_t mask = masks_[number]; mask != 0; mask &= mask - 1) {
        const auto place = static_cast<std::size_t>(std::countr_zero(mask));
        all[number * kSlotBlock + place] = blocks_[number][place];
      }
    }
    *this = SlotBlocks();
    all_ = std::move(all);
    by_slot_ = true;
  }
  /// By slot, once all lie so.
  List<T>& all() { return all_; }
  const List<T>& all() const { return all_; }

  std::size_t bytes() const {
    return all_.bytes() + blocks_.bytes() + masks_.bytes() + used_.bytes() + room_.bytes() +
           room_.size() * kSlotBlock * sizeof(T);
  }

 private:
  // Small enough that nobody waits for its pages.
  static constexpr std::size_t kBlocksOfChunk = 64;

  // A world with a few movers gets room for a few.
  void take_chunk(std::size_t wanted) {
    const std::size_t count = std::min(std::max(wanted, room_.size() / 2), kBlocksOfChunk);
    room_.reserve(room_.size() + count);
    chunks_.reserve(chunks_.size() + 1);
    chunks_.emplace_back(reinterpret_cast<T*>(take_memory(count * kSlotBlock * sizeof(T), alignof(T))));
    for (std::size_t block = 0; block < count; ++block) room_.push(chunks_.back().get() + block * kSlotBlock);
  }

  List<T*> blocks_;                // by number
  List<std::uint64_t> masks_;      // by number: which of its slots have something; of others nothing counts
  List<std::uint32_t> used_;       // numbers of blocks in use
  List<T*> room_;                  // for these, and for more
  std::vector<Memory<T>> chunks_;  // which lies in these
  List<T> all_;                    // by slot
  bool by_slot_ = false;
};

}  // namespace cellsweep
