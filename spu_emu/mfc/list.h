/// @file
/// The elements of a DMA list, read by value from a local store.
#ifndef SPU_EMU_MFC_LIST_H
#define SPU_EMU_MFC_LIST_H

#include <cstdint>

#include "mfc/local_store.h"

namespace spu_emu {

/// {notify:1, reserved:16, size:15} and the low half of the EA, as two words.
struct ListElement {
  std::uint32_t first_word = 0;
  std::uint32_t ea_low = 0;

  constexpr bool notify() const { return (first_word >> 31U) != 0; }
  constexpr std::uint32_t size() const { return first_word & 0x7fffU; }
  friend bool operator==(const ListElement&, const ListElement&) = default;
};

/// Element `index` of the list at LS address `list`; all of it must lie in the local store.
ListElement read_list_element(LocalStoreView& store, std::uint32_t list, std::uint32_t index);

/// Where an element's transfer starts: `ls` rounded down to 16, plus the low 4 bits of the element's EA.
constexpr std::uint32_t element_ls(std::uint32_t ls, const ListElement& element) {
  return (ls & ~15U) | (element.ea_low & 15U);
}

/// Where the next element's transfer starts, not counting its own low 4 bits.
constexpr std::uint32_t next_element_ls(std::uint32_t ls, const ListElement& element) {
  return (ls & ~15U) + ((element.size() + 15U) & ~15U);
}

}  // namespace spu_emu

#endif
