/// @file
/// One SPU that executes real instructions from a local store.
#ifndef SPU_EMU_ISA_CORE_MACHINE_H
#define SPU_EMU_ISA_CORE_MACHINE_H

#include <cstddef>
#include <cstdint>
#include <memory>

namespace spu_emu {
class SpuChannels;
}

namespace spu_emu::isa {

class InstructionObserver;
class InstructionTraps;

/// Why run() came back.
struct MachineStop {
  enum class Kind {
    stop,        // a stop or stopd; `code` is its type of 14 bits (stopd: 0x3fff), `pc` the address after it
    halt,        // the condition of a halt instruction held; `pc` is its address
    illegal,     // no instruction has this encoding, which `code` holds; `pc` is its address
    budget,      // `max_instructions` were executed
    interrupted  // interrupt() was called
  };
  Kind kind;
  std::uint32_t code;
  std::uint32_t pc;
};

/// For one thread, but where a function says otherwise. Never waits but in a channel instruction.
class Machine {
 public:
  /// `local_store` has 256 KB in the SPU's byte order and is aligned to 128. Channel instructions go to
  /// `channels`. Both outlive the machine.
  Machine(std::byte* local_store, SpuChannels& channels);
  ~Machine();
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  /// From now on `observer`, which is there as long as the machine runs, is told of every instruction.
  void set_observer(InstructionObserver& observer);

  /// From now on `traps`, which are there as long as the machine, are asked before the instructions they
  /// want.
  void set_traps(InstructionTraps& traps);
  /// What the traps want has changed: nothing decoded is kept. By the thread that runs the machine, also out
  /// of a call of the traps or a channel.
  void decode_again();
  /// Calls the traps' attend() between two blocks, soon. Any thread, and handlers of signals.
  void ask_for_attention();

  /// Registers, FPSCR and pc are zero, interrupts are disabled, and nothing decoded is kept.
  void reset();

  /// Executes exactly `max_instructions` unless something else ends the run before. interrupt() and what
  /// other threads write are noticed between basic blocks. A broken rule of channels or MFC comes through as
  /// Fault; then pc() is the instruction's address and it counts as not executed.
  MachineStop run(std::uint64_t max_instructions);

  std::uint32_t pc() const;
  /// Cut down to a word's address in the local store.
  void set_pc(std::uint32_t pc);
  /// `reg` 0 to 127, `slot` 0 to 3; slot 0 is the preferred one.
  std::uint32_t word(unsigned reg, unsigned slot) const;
  void set_word(unsigned reg, unsigned slot, std::uint32_t value);
  /// A word of the floating-point status and control register.
  std::uint32_t fpscr(unsigned slot) const;
  /// Executed since the machine was made or reset.
  std::uint64_t instructions() const;

  /// Bytes were written by somebody else (DMA, another SPE, the host): instructions there are decoded again.
  /// Any thread; to be called after the bytes are there.
  void local_store_written(std::uint32_t first, std::uint32_t size);

  /// Ends the run at the next block, or the next run() before its first instruction. Any thread. Does not
  /// wake a channel instruction that waits.
  void interrupt();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace spu_emu::isa

#endif
