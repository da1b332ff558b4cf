/// @file
/// What an SPE runs: a loaded program of either engine, and the thread of control in it.
#ifndef SPU_EMU_SPE_PROGRAM_H
#define SPU_EMU_SPE_PROGRAM_H

#include <cstdint>
#include <string>

#include "mfc/fault.h"
#include "mfc/local_store.h"
#include "spu_emu/cycles.h"

namespace spu_emu {

/// Why control came back from the program.
struct Stop {
  enum class Kind { exit, signal, library_call, fault };
  Kind kind = Kind::exit;
  /// The 14-bit code, for a library call with the LS address of its argument word.
  unsigned int code = 0;
  std::uint32_t argument = 0;
  StopReport report{};
};

/// What a program is started with; `user_registers` are r3, r4 and r5 word by word when the caller gave them.
struct Arguments {
  unsigned long long speid = 0;
  unsigned long long argp = 0;
  unsigned long long envp = 0;
  const unsigned int* user_registers = nullptr;
};

/// Used by one thread at a time; the threads may differ. No function throws Fault: a broken rule is a Stop.
class Program {
 public:
  Program() = default;
  virtual ~Program() = default;
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// The local store as this program's MFC sees it, and its size in bytes.
  virtual LocalStoreView& store() = 0;
  virtual std::uint32_t store_size() const = 0;

  /// Starts the program at its entry, whatever it did before, and runs until it stops.
  virtual Stop start(const Arguments& arguments) = 0;
  /// Goes on at `entry`, which can_resume has said is possible, and runs until the next stop.
  virtual Stop resume(unsigned int entry) = 0;
  virtual bool can_resume(unsigned int entry) const = 0;
  /// Whether to go on there is to start anew, with arguments.
  virtual bool begins_at(unsigned int) const { return false; }
  /// The entry at which a stopped program goes on.
  virtual unsigned int resume_entry() const = 0;
  /// The same after a library call that was served: behind the call's argument word.
  virtual unsigned int entry_after_call() const = 0;

  /// The LS address of what a program calls one, in words that it sends: there it may be the low half of a
  /// pointer.
  virtual std::uint32_t ls_address(std::uint32_t number) const { return number; }

  /// Serves a library call that the host program registered no handler for; 0, or what a handler that failed
  /// returns.
  virtual int serve_library_call(const Stop& call) = 0;

  /// Bytes of local store in use at most. Any thread.
  virtual std::uint32_t high_water() const = 0;
  /// Several lines: every part of the local store with its LS addresses and sizes.
  virtual std::string map() const = 0;
  /// What there is of real SPU code only: where it stands, all registers, instructions executed, cycles. The
  /// counts may be read by any thread.
  virtual std::string where() const { return {}; }
  virtual std::string registers() const { return {}; }
  /// The instruction that waits, for any thread while one does.
  virtual std::string where_waiting() const { return {}; }
  virtual std::uint64_t instructions() const { return 0; }
  virtual CycleProfile cycle_profile() const { return {}; }
};

}  // namespace spu_emu

#endif
