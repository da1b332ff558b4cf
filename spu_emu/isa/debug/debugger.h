/// @file
/// The debugger of one SPU: stops its program where it was asked to, and does commands while it stands.
#ifndef SPU_EMU_ISA_DEBUG_DEBUGGER_H
#define SPU_EMU_ISA_DEBUG_DEBUGGER_H

#include <atomic>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "isa/core/instruction_traps.h"
#include "isa/debug/console.h"
#include "isa/debug/interruption.h"
#include "isa/debug/session.h"
#include "mfc/wait_listener.h"

namespace spu_emu::isa {

/// Everything but store_written() is for the thread that runs the program. The machine has no traps and the
/// channels no listener before there is a debugger, so that programs without one run as fast as ever.
class Debugger final : private InstructionTraps, private WaitListener {
 public:
  /// `commands` is a file, or empty for standard input. `elf_file` is read here and now. Throws
  /// std::runtime_error when the commands cannot be read.
  Debugger(Spe& spe, Machine& machine, std::byte* store, const std::string& commands,
           std::vector<ElfSymbol> symbols, std::span<const std::byte> elf_file);
  ~Debugger();

  /// The program begins: it will stop before its first instruction.
  void started();
  /// The program goes on after it stood still for its host.
  void resumed();
  /// It is about to end because it broke a rule; `text` says which.
  void failed(const std::string& text);
  /// It has ended by itself.
  void ended(std::uint32_t exit_code);
  /// Bytes of the local store were changed by somebody else. Any thread.
  void store_written();

 private:
  bool wants(std::uint32_t pc, std::uint32_t word) const override;
  bool come(std::uint32_t pc) override;
  void attend() override;
  void still_waiting(const char* what) override;

  std::string returned_text() const;
  std::vector<std::string> reasons_from_outside();
  void stop(const std::vector<std::string>& reasons);
  void ask();
  void do_command(const std::string& line);
  void detach();
  bool leave(std::uint32_t pc);
  bool take_changes();

  Session session_;
  Console console_;
  std::optional<CtrlC> ctrl_c_;
  Timer timer_;
  const std::string prompt_;
  std::string last_line_;
  std::atomic<std::thread::id> spu_thread_;
  std::atomic<bool> written_here_{false};
  std::atomic<bool> written_elsewhere_{false};
  bool starts_ = false;
  bool detached_ = false;
  /// Everything was done for the instruction at this address, which is only decoded again.
  std::optional<std::uint32_t> done_at_;
  /// The program stands here already: it need not stop once more.
  std::optional<std::uint32_t> standing_at_;
};

}  // namespace spu_emu::isa

#endif
