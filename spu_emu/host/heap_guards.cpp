#include "host/heap_guards.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace spu_emu {

namespace {
/// No number, text or picture that a program is likely to write there.
constexpr std::array<unsigned char, Heap::kGuardBytes> kMark = {
    0xd3, 0x5a, 0x91, 0x3c, 0xe7, 0x4b, 0xa9, 0x1d, 0x8e, 0x73, 0xf5, 0x2b, 0xc6, 0x95, 0x6d, 0xb8};
}  // namespace

void HeapGuards::mark(std::uint32_t ls) const {
  if (const auto guard = heap_.guard_of(ls)) mark(*guard);
}

void HeapGuards::mark(const Heap::Guard& guard) const {
  std::memcpy(base_ + guard.first, kMark.data(), kMark.size());
}

void HeapGuards::mark_all() const {
  for (const Heap::Guard& guard : heap_.guards()) mark(guard);
}

std::optional<HeapOverrun> HeapGuards::overrun_of(std::uint32_t ls) const {
  const auto guard = heap_.guard_of(ls);
  return guard ? overrun_of(*guard) : std::nullopt;
}

std::optional<HeapOverrun> HeapGuards::any_overrun() const {
  for (const Heap::Guard& guard : heap_.guards()) {
    if (const auto overrun = overrun_of(guard)) return overrun;
  }
  return std::nullopt;
}

std::optional<HeapOverrun> HeapGuards::overrun_of(const Heap::Guard& guard) const {
  const auto* found = reinterpret_cast<const unsigned char*>(base_ + guard.first);
  const auto changed = std::mismatch(kMark.begin(), kMark.end(), found).second - found;
  if (changed == static_cast<std::ptrdiff_t>(kMark.size())) return std::nullopt;
  return HeapOverrun{guard.block, guard.asked, guard.first + static_cast<std::uint32_t>(changed)};
}

}  // namespace spu_emu
