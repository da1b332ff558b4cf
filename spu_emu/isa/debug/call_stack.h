/// @file
/// The functions that have called each other, found by the rules of the SPU's ABI.
#ifndef SPU_EMU_ISA_DEBUG_CALL_STACK_H
#define SPU_EMU_ISA_DEBUG_CALL_STACK_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "isa/debug/code_map.h"

namespace spu_emu::isa {

/// One call in progress.
struct Frame {
  /// Where the function stands: the instruction that is next in it, or that a call comes back to.
  std::uint32_t pc = 0;
  /// Of its caller, once it has returned: stack pointer and next instruction; 0: there is none.
  std::uint32_t caller_sp = 0;
  std::uint32_t return_address = 0;
};

/// The innermost first. In the frame of a function the word at r1 leads to its caller's frame, whose second
/// quadword keeps where the function returns to. Whether the innermost function has made its frame yet, and
/// saved r0, its instructions from its symbol on say. The walk ends where the chain does, or makes no sense
/// any more.
std::vector<Frame> call_stack(const Machine& machine, const std::byte* store, const CodeMap& map);

}  // namespace spu_emu::isa

#endif
