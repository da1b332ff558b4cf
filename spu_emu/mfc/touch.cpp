#include "mfc/touch.h"

#include <atomic>

// Each touches one byte and returns true; a handler of signals makes it go on where it returns false.
#ifdef __x86_64__
extern "C" {
[[gnu::visibility("hidden")]] bool spu_emu_touch_to_read(std::uintptr_t address);
[[gnu::visibility("hidden")]] bool spu_emu_touch_to_write(std::uintptr_t address);
[[gnu::visibility("hidden")]] extern const char spu_emu_touch_failed[];
}
asm(R"(
  .pushsection .text
  .hidden spu_emu_touch_to_read
  .globl spu_emu_touch_to_read
  .type spu_emu_touch_to_read, @function
spu_emu_touch_to_read:
  movb (%rdi), %al
  movl $1, %eax
  ret
  .size spu_emu_touch_to_read, . - spu_emu_touch_to_read
  .hidden spu_emu_touch_to_write
  .globl spu_emu_touch_to_write
  .type spu_emu_touch_to_write, @function
spu_emu_touch_to_write:
  lock orb $0, (%rdi)
  movl $1, %eax
  ret
  .size spu_emu_touch_to_write, . - spu_emu_touch_to_write
  .hidden spu_emu_touch_failed
  .globl spu_emu_touch_failed
spu_emu_touch_failed:
  xorl %eax, %eax
  ret
  .popsection
)");
#endif

namespace spu_emu {

namespace {
std::atomic<bool> is_guarded{false};
}

void guard_touches(bool guarded) {
  is_guarded.store(guarded, std::memory_order_release);
}

#ifdef __x86_64__

std::uintptr_t touch_goes_on_at(std::uintptr_t instruction) {
  const bool touches = instruction == reinterpret_cast<std::uintptr_t>(&spu_emu_touch_to_read) ||
                       instruction == reinterpret_cast<std::uintptr_t>(&spu_emu_touch_to_write);
  return touches ? reinterpret_cast<std::uintptr_t>(&spu_emu_touch_failed) : 0;
}

bool can_touch(std::uint64_t first, std::uint64_t size, Access access) {
  constexpr std::uint64_t kPageBytes = 4096;
  if (!is_guarded.load(std::memory_order_acquire)) return is_mapped(first, size, access);
  const std::uint64_t end = first + size;
  const auto touch = access == Access::write ? &spu_emu_touch_to_write : &spu_emu_touch_to_read;
  for (std::uint64_t at = first; at < end; at = (at & ~(kPageBytes - 1)) + kPageBytes) {
    if (!touch(at)) return false;
  }
  return true;
}

#else

std::uintptr_t touch_goes_on_at(std::uintptr_t) {
  return 0;
}

bool can_touch(std::uint64_t first, std::uint64_t size, Access access) {
  return is_mapped(first, size, access);
}

#endif

}  // namespace spu_emu
