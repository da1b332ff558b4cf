/// @file
/// What the cycle model needs to know of one instruction word.
#ifndef SPU_EMU_ISA_TIMING_TIMED_INSTRUCTION_H
#define SPU_EMU_ISA_TIMING_TIMED_INSTRUCTION_H

#include <cstdint>

#include "spu_emu/cycles.h"

namespace spu_emu::isa {

struct TimedInstruction {
  enum class Kind : std::uint8_t { plain, memory, branch, hint, read_channel, write_channel };

  static constexpr std::uint8_t kNone = 0xff;

  std::uint32_t word = 0;
  Kind kind = Kind::plain;
  bool known = false;  // the rest belongs to `word`
  bool even = true;
  bool pauses_issue = false;                        // double precision
  std::uint32_t latency = 0;                        // cycles until the target can be used
  std::uint8_t target = kNone;                      // register written
  std::uint8_t sources[3] = {kNone, kNone, kNone};  // registers read
  Stall waiting = Stall::fixed;                     // what those wait for who wait for its result
  std::uint32_t channel = 0;
  std::uint32_t hinted_branch = 0;  // address, of a hint
  std::uint32_t hinted_target = 0;  // address, of a hint with a fixed target
  bool hint_by_register = false;
};

/// Of the word at `pc`; one that encodes no instruction is a plain one.
TimedInstruction time_instruction(const CycleParameters& parameters, std::uint32_t word, std::uint32_t pc);

}  // namespace spu_emu::isa

#endif
