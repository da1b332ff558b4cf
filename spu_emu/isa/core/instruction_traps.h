/// @file
/// Who is asked before instructions of its choice, and may keep the machine standing there: a debugger.
#ifndef SPU_EMU_ISA_CORE_INSTRUCTION_TRAPS_H
#define SPU_EMU_ISA_CORE_INSTRUCTION_TRAPS_H

#include <cstdint>

namespace spu_emu::isa {

/// Called by the thread that runs the machine, under the host's floating-point mode; Machine::pc() and
/// instructions() are then right. Instructions that nobody wants run as if there were no traps.
class InstructionTraps {
 public:
  /// Whether `come` is to be called before the instruction `word` at `pc`. Asked when it is decoded; who
  /// changes his mind says so by Machine::decode_again().
  virtual bool wants(std::uint32_t pc, std::uint32_t word) const = 0;

  /// The instruction at `pc` is the next one. False if decode_again() was called meanwhile: then the
  /// instruction is decoded anew, and this may be called for it once more.
  virtual bool come(std::uint32_t pc) = 0;

  /// Between two blocks, after Machine::ask_for_attention().
  virtual void attend() = 0;

 protected:
  ~InstructionTraps() = default;
};

}  // namespace spu_emu::isa

#endif
