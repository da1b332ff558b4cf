/// @file
/// Who is told of every instruction that a machine executes.
#ifndef SPU_EMU_ISA_CORE_INSTRUCTION_OBSERVER_H
#define SPU_EMU_ISA_CORE_INSTRUCTION_OBSERVER_H

#include <cstdint>

namespace spu_emu::isa {

struct State;

/// Called by the thread that runs the machine.
class InstructionObserver {
 public:
  /// The program begins anew.
  virtual void restart() = 0;

  /// The instruction at `pc` is about to be executed with `state`, after the one of the call before.
  virtual void begin(std::uint32_t pc, const State& state) = 0;
  /// The run ends after the instruction begun last, and goes on at `next_pc` some time.
  virtual void end(std::uint32_t next_pc, const State& state) = 0;
  /// The run ends because the instruction begun last broke a rule or encodes none: it is not executed.
  virtual void cancel() = 0;

 protected:
  ~InstructionObserver() = default;
};

}  // namespace spu_emu::isa

#endif
