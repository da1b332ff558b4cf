#include "mfc/list.h"

#include <array>
#include <cstring>

namespace spu_emu {

ListElement read_list_element(LocalStoreView& store, std::uint32_t list, std::uint32_t index) {
  std::array<std::uint32_t, 2> words{};
  std::memcpy(words.data(), store.at(list + index * 8, 8), 8);
  if (store.word_order() == WordOrder::swapped) {
    for (std::uint32_t& word : words) word = __builtin_bswap32(word);
  }
  return {words[0], words[1]};
}

}  // namespace spu_emu
