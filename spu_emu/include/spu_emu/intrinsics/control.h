// Intrinsics that steer the processor instead of computing: halts, the FPSCR, special registers, branches,
// hints.
//
// A halt whose condition holds ends the program (spu_emu_halt of channels.h). The FPSCR keeps the two double
// slots' rounding modes and no exception flags. Special-purpose registers read as zero and ignore writes.
// Interrupt-style calls (spu_bisled) make the call when it is possible on the host: the event conditions that
// the _d and _e forms would switch do not exist here.
#ifndef SPU_EMU_INTRINSICS_CONTROL_H
#define SPU_EMU_INTRINSICS_CONTROL_H

#include "spu_emu/channels.h"
#include "spu_emu/intrinsics/double.h"

// Halts when a equals b.
SPU_EMU_INLINE void spu_hcmpeq(int a, int b, const char* file = __builtin_FILE(),
                               int line = __builtin_LINE()) {
  if (a == b) spu_emu_halt(file, line);
}

SPU_EMU_INLINE void spu_hcmpeq(unsigned int a, unsigned int b, const char* file = __builtin_FILE(),
                               int line = __builtin_LINE()) {
  if (a == b) spu_emu_halt(file, line);
}

// Halts when a is greater than b.
SPU_EMU_INLINE void spu_hcmpgt(int a, int b, const char* file = __builtin_FILE(),
                               int line = __builtin_LINE()) {
  if (a > b) spu_emu_halt(file, line);
}

SPU_EMU_INLINE void spu_hcmpgt(unsigned int a, unsigned int b, const char* file = __builtin_FILE(),
                               int line = __builtin_LINE()) {
  if (a > b) spu_emu_halt(file, line);
}

// Bits 20-21 and 22-23 of the register, counted from the left, are the rounding modes of slots 0 and 1.
SPU_EMU_INLINE vec_uint4 spu_mffpscr() {
  const spu_emu::detail::DoubleRounding mode = spu_emu::detail::double_rounding();
  return vec_uint4{(mode.slot[0] << 10) | (mode.slot[1] << 8), 0, 0, 0};
}

SPU_EMU_INLINE void spu_mtfpscr(vec_uint4 value) {
  spu_emu::detail::double_rounding() = {{(value[0] >> 10) & 3, (value[0] >> 8) & 3}};
}

SPU_EMU_INLINE unsigned int spu_mfspr(unsigned int) {
  return 0;
}

SPU_EMU_INLINE void spu_mtspr(unsigned int, unsigned int) {}

namespace spu_emu::detail {

// Whether the branch on external data would be taken: an event that the program asked for is waiting.
SPU_EMU_INLINE bool event_is_waiting() {
  return spu_readchcnt(SPU_RdEventStat) != 0;
}

SPU_EMU_INLINE void call_on_event(void* function) {
  if (event_is_waiting()) reinterpret_cast<void (*)()>(function)();
}

}  // namespace spu_emu::detail

// Calls `function` when an event is waiting. The second argument, a link register, has no use here.
SPU_EMU_INLINE void spu_bisled(void* function, void*) {
  spu_emu::detail::call_on_event(function);
}

SPU_EMU_INLINE void spu_bisled_d(void* function, void*) {
  spu_emu::detail::call_on_event(function);
}

SPU_EMU_INLINE void spu_bisled_e(void* function, void*) {
  spu_emu::detail::call_on_event(function);
}

// A hint about alignment of code and a base pointer; the host compiler has no use for it.
SPU_EMU_INLINE void spu_align_hint(const void*, int, int) {}

// The pattern by which spu_shuffle(a, a, pattern) moves a quadword right by the address's offset in its
// quadword.
SPU_EMU_INLINE vec_char16 spu_lvsr(const void* address) {
  const int offset = static_cast<int>(reinterpret_cast<std::uintptr_t>(address) & 15);
  const vec_char16 first = {16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31};
  return first - spu_emu::detail::splat<vec_char16>(static_cast<signed char>(offset));
}

#endif
