/// @file
/// A program of the instruction-level engine: an SPU ELF file in a machine that executes it.
#ifndef SPU_EMU_ISA_ISA_PROGRAM_H
#define SPU_EMU_ISA_ISA_PROGRAM_H

#include <atomic>
#include <memory>
#include <vector>

#include "isa/core/machine.h"
#include "isa/debug/debugger.h"
#include "isa/elf/overlay_image.h"
#include "isa/elf/program_store.h"
#include "isa/libc/library_calls.h"
#include "isa/timing/cycle_model.h"
#include "spe/program_loader.h"
#include "spe/spe.h"

namespace spu_emu::isa {

class IsaProgram final : public Program, private StoreObserver {
 public:
  static LoadResult load(Spe& spe, const ProgramImage& image);
  explicit IsaProgram(Spe& spe);

  LocalStoreView& store() override { return store_.view(); }
  std::uint32_t store_size() const override { return store_.limit(); }
  Stop start(const Arguments& arguments) override;
  Stop resume(unsigned int entry) override;
  bool can_resume(unsigned int entry) const override;
  bool begins_at(unsigned int entry) const override { return entry == entry_; }
  unsigned int resume_entry() const override { return machine_.pc(); }
  unsigned int entry_after_call() const override { return machine_.pc() + 4; }
  int serve_library_call(const Stop& call) override;
  std::uint32_t high_water() const override { return high_water_.load(std::memory_order_relaxed); }
  std::string map() const override { return store_.map(); }
  std::string where() const override { return place_of(stopped_at_); }
  std::string where_waiting() const override { return place_of(machine_.pc()); }
  std::string registers() const override;
  std::uint64_t instructions() const override { return instructions_.load(std::memory_order_relaxed); }
  CycleProfile cycle_profile() const override { return cycles_ ? cycles_->profile() : CycleProfile(); }

 private:
  void attach_debugger(std::span<const std::byte> file);
  void store_written(std::uint32_t ls, std::uint32_t size) noexcept override;
  void set_registers(const Arguments& arguments);
  void set_doubleword(unsigned reg, std::uint64_t value);
  Stop run();
  Stop translate(const MachineStop& stop);
  Stop at_stop_instruction(const MachineStop& stop);
  MachineStop execute();
  MachineStop run_until_deadline(std::uint64_t most);
  Stop end_by(const Fault& fault);
  std::string place_of(std::uint32_t pc) const;
  void note_progress();

  Spe& spe_;
  ProgramStore store_;
  std::unique_ptr<CycleModel> cycles_;  // when the settings ask for it
  Machine machine_;
  std::unique_ptr<Debugger> debugger_;  // when the settings or the environment ask for it
  LibraryCalls calls_;
  OverlayImage overlays_;
  std::uint32_t entry_ = 0;
  /// The instruction of the last stop.
  std::uint32_t stopped_at_ = 0;
  std::vector<ElfSymbol> symbols_;
  /// A fault has ended it: only a start goes on.
  bool is_over_ = false;
  /// What the host changed in the store while the program stood still is known.
  bool store_known_ = false;
  std::atomic<std::uint32_t> high_water_{0};
  std::atomic<std::uint64_t> instructions_{0};
};

}  // namespace spu_emu::isa

#endif
