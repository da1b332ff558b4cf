#include "mfc/watch.h"

#include <algorithm>
#include <cstring>

#if defined(__SANITIZE_ADDRESS__)
#define SPU_EMU_WITH_ASAN 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SPU_EMU_WITH_ASAN 1
#endif
#endif

#ifdef SPU_EMU_WITH_ASAN
#include <sanitizer/asan_interface.h>
#endif

namespace spu_emu {

void allow_access([[maybe_unused]] const std::byte* first, [[maybe_unused]] std::size_t size) {
#ifdef SPU_EMU_WITH_ASAN
  __asan_unpoison_memory_region(first, size);
#endif
}

bool overlap(const Piece& one, const Piece& other) {
  return one.host < other.host + other.size && other.host < one.host + one.size;
}

void poison(const std::vector<Piece>& pieces) {
  for (const Piece& piece : pieces) {
    std::memset(piece.host, std::to_integer<int>(kPoison), piece.size);
  }
}

void forbid_access([[maybe_unused]] const std::vector<Piece>& pieces) {
#ifdef SPU_EMU_WITH_ASAN
  for (const Piece& piece : pieces) __asan_poison_memory_region(piece.host, piece.size);
#endif
}

bool end_poison(const std::vector<Piece>& pieces) {
  bool untouched = true;
  for (const Piece& piece : pieces) {
    allow_access(piece.host, piece.size);
    untouched = untouched && std::all_of(piece.host, piece.host + piece.size,
                                         [](std::byte byte) { return byte == kPoison; });
  }
  return untouched;
}

std::vector<std::byte> snapshot(const std::vector<Piece>& pieces) {
  std::vector<std::byte> bytes;
  for (const Piece& piece : pieces) bytes.insert(bytes.end(), piece.host, piece.host + piece.size);
  return bytes;
}

}  // namespace spu_emu
