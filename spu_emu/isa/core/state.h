/// @file
/// What the instructions of one SPU work on: registers, FPSCR, local store, and the bookkeeping of running
/// them.
#ifndef SPU_EMU_ISA_CORE_STATE_H
#define SPU_EMU_ISA_CORE_STATE_H

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "isa/encoding/instruction_word.h"
#include "spu_emu/intrinsics/float_mode.h"
#include "spu_emu/intrinsics/qword.h"

namespace spu_emu {
class SpuChannels;
}

namespace spu_emu::isa {

class BlockCache;
class InstructionObserver;
class InstructionTraps;
struct Op;
struct State;

/// Executes one decoded instruction. Gives the one to go on with, or null when run() has to look: then
/// State::pc is the next address, and the instructions executed are taken from State::budget.
using Handler = const Op* (*)(State&, const Op*);

/// One decoded instruction. Registers are byte offsets into State::registers.
struct Op {
  Handler run;
  std::uint16_t t;
  std::uint16_t a;
  std::uint16_t b;
  std::uint16_t c;
  std::int32_t immediate;  // extended, scaled, and an address where the instruction names one
  std::uint32_t pc;
  std::uint32_t count;  // instructions from the start of the block up to and with this one
};

constexpr std::uint32_t kQuadwordMask = kLocalStoreSize - 16;
constexpr std::uint32_t kWords = kLocalStoreSize / 4;
constexpr std::uint32_t kQuadwords = kLocalStoreSize / 16;

/// A block never has more instructions.
constexpr std::uint32_t kMaxBlock = 64;

/// Why an instruction ended the run, if it did.
enum class Exit : std::uint8_t { none, stop, halt, illegal };

/// Reasons for the run to look up between blocks: bits of State::attention.
enum Attention : std::uint32_t { kInterrupted = 1, kWritten = 2, kInterruptsEnabled = 4, kTrap = 8 };

/// Registers are kept as four words in the host's byte order, the preferred one first; the local store is as
/// on the SPU, big-endian.
struct State {
  vec_uint4 registers[128] = {};
  std::byte* store = nullptr;
  /// Where the blocks start that begin at each word; null where none is decoded.
  std::array<const Op*, kWords>* entries = nullptr;
  /// Not 0 for quadwords that decoded instructions came from.
  std::array<std::uint8_t, kQuadwords>* code = nullptr;
  std::uint64_t budget = 0;  // instructions that may still be executed
  std::atomic<std::uint32_t> attention{0};
  std::uint32_t pc = 0;
  Exit exit = Exit::none;
  std::uint32_t stop_code = 0;
  /// Single-precision flags in each word's low bits, double-precision flags and modes as fscrrd gives them.
  vec_uint4 fpscr{};
  SpuChannels* channels = nullptr;
  BlockCache* blocks = nullptr;
  /// Told of every instruction if there is one: then blocks are decoded with a call of it before each.
  InstructionObserver* observer = nullptr;
  /// Asked before the instructions that it wants: then a call of it is decoded before each of these.
  InstructionTraps* traps = nullptr;
  FloatControl host_float_control{};

  qword& at(std::uint16_t offset) {
    return *reinterpret_cast<qword*>(reinterpret_cast<std::byte*>(registers) + offset);
  }
  const qword& at(std::uint16_t offset) const {
    return *reinterpret_cast<const qword*>(reinterpret_cast<const std::byte*>(registers) + offset);
  }
  std::uint32_t preferred(std::uint16_t offset) const { return static_cast<vec_uint4>(at(offset))[0]; }
  /// A scalar result: zero in the other slots.
  void set_preferred(std::uint16_t offset, std::uint32_t value) {
    at(offset) = static_cast<qword>(vec_uint4{value, 0, 0, 0});
  }
};

/// What a handler returns to have `op` executed: a call of its handler in the caller's place where the
/// compiler is known to make it one, or `op` itself, which the machine executes then.
inline const Op* execute(State& state, const Op* op) {
#ifdef SPU_EMU_ISA_TAIL_CALLS
  return op->run(state, op);
#else
  static_cast<void>(state);
  return op;
#endif
}

/// The end of a handler whose instruction is followed by the next one.
inline const Op* go_on(State& state, const Op* op) {
  return execute(state, op + 1);
}

/// Leaves the block after `op`; the run looks up and goes on at `target`.
inline const Op* leave(State& state, const Op* op, std::uint32_t target) {
  state.budget -= op->count;
  state.pc = target;
  return nullptr;
}

/// Goes on at `target` (a word's address), straight into its block if nothing speaks against that.
inline const Op* go_to(State& state, const Op* op, std::uint32_t target) {
  const Op* next = (*state.entries)[target / 4];
  state.budget -= op->count;
  if (next != nullptr && state.budget >= kMaxBlock && state.attention.load(std::memory_order_relaxed) == 0)
      [[likely]] {
    return execute(state, next);
  }
  state.pc = target;
  return nullptr;
}

/// The address after an instruction.
inline std::uint32_t address_after(const Op* op) {
  return (op->pc + 4) & kCodeMask;
}

}  // namespace spu_emu::isa

#endif
