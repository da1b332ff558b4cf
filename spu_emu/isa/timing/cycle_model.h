/// @file
/// The clock of an SPU: when each executed instruction would issue on a Cell.
#ifndef SPU_EMU_ISA_TIMING_CYCLE_MODEL_H
#define SPU_EMU_ISA_TIMING_CYCLE_MODEL_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "isa/core/instruction_observer.h"
#include "isa/timing/mfc_clock.h"
#include "isa/timing/timed_instruction.h"
#include "spu_emu/cycles.h"

namespace spu_emu::isa {

/// A piece of the program's code with a name.
struct CodeRange {
  std::uint32_t first = 0;
  std::uint32_t end = 0;
  std::string name;
};

/// In order, two pipes: the two instructions of an aligned pair issue together when the first is of the even
/// and the second of the odd pipe and nothing holds the second back. Used by the thread that runs the
/// machine, but for profile().
///
/// What the program waits for from outside the SPE (mailboxes, signals, events) takes no cycles: this clock
/// is the SPU's work and its DMA, not the wall.
class CycleModel final : public InstructionObserver {
 public:
  /// `local_store` of 256 KB, in the SPU's byte order, outlives the model.
  CycleModel(const CycleParameters& parameters, const std::byte* local_store);
  CycleModel(const CycleModel&) = delete;
  CycleModel& operator=(const CycleModel&) = delete;

  /// Names the parts of the program, which do not overlap; what was counted before is forgotten. Not while
  /// the program runs.
  void set_code(std::vector<CodeRange> code);

  /// Nothing is in flight, no hint is known. What is counted stays.
  void restart() override;

  void begin(std::uint32_t pc, const State& state) override;
  void end(std::uint32_t next_pc, const State& state) override;
  /// The instruction begun last does not count.
  void cancel() override;

  /// As of the last end, cancel, or write to an outbound mailbox. Any thread.
  CycleProfile profile() const;

 private:
  static constexpr std::uint32_t kNowhere = ~0U;

  struct Hint {
    std::uint32_t branch = kNowhere;
    std::uint32_t target = 0;
    std::uint64_t issued = 0;  // cycle
    std::uint64_t number = 0;  // instructions executed up to and with it
  };
  /// What profile() may read.
  struct Published {
    std::vector<CycleCounts> counts;
    std::uint64_t dma_commands = 0;
    std::uint64_t dma_bytes = 0;
  };

  const TimedInstruction& instruction_at(std::uint32_t pc);
  void finish_begun(std::uint32_t next_pc, const State& state);
  std::uint64_t issue_cycle(const TimedInstruction& instruction, std::uint32_t value, std::uint32_t result);
  void count(std::uint64_t at, bool paired);
  void note_results(const TimedInstruction& instruction, std::uint64_t at);
  void predict(std::uint32_t next_pc, std::uint64_t at);
  void delay(std::uint64_t& at, std::uint64_t until, Stall cause);
  void wait_for_operands(const TimedInstruction& instruction, std::uint64_t& at);
  void wait_for_port(std::uint64_t& at);
  void wait_for_fetch(std::uint64_t& at);
  void publish();

  CycleParameters parameters_;
  const std::byte* local_store_;
  MfcClock mfc_;
  std::vector<CodeRange> code_;
  std::vector<TimedInstruction> decoded_;  // by word
  std::vector<std::uint32_t> range_of_;    // by word: index into counts_
  std::vector<CycleCounts> counts_;        // one for each range, the last for the rest
  mutable std::mutex published_mutex_;
  Published published_;

  std::array<std::uint64_t, 128> ready_{};  // cycle from which a register can be used
  std::array<Stall, 128> producer_{};
  Hint hint_;
  std::uint64_t now_ = 0;           // cycles that are over
  std::uint64_t instructions_ = 0;  // executed
  std::uint64_t last_issue_ = 0;
  bool last_can_lead_ = false;           // the last instruction may be the first of a pair
  std::uint32_t after_last_ = kNowhere;  // address behind it
  std::uint64_t issue_floor_ = 0;        // nothing issues before
  Stall floor_cause_ = Stall::branch_miss;
  std::uint64_t line_entered_ = 0;
  std::uint64_t port_uses_in_line_ = 0;

  // The instruction begun and not yet finished.
  const TimedInstruction* begun_ = nullptr;
  std::uint32_t pc_ = 0;
  std::uint32_t value_ = 0;         // that it writes to a channel or hints at
  CycleCounts* current_ = nullptr;  // where it is counted
};

}  // namespace spu_emu::isa

#endif
