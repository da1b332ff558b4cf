/// @file
/// Keeps a program's own errors (bad addresses, division by zero, abort(), loops without an end) from ending
/// the process.
#ifndef SPU_EMU_HOST_PROGRAM_GUARD_H
#define SPU_EMU_HOST_PROGRAM_GUARD_H

#include <signal.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "host/sanitizers.h"

namespace spu_emu {

/// A sanitizer reports such errors itself, in more words, and keeps accounts of stacks that a signal handler
/// must not leave: in its builds nothing is guarded.
#ifdef SPU_EMU_SANITIZED
inline constexpr bool kGuardsPrograms = false;
#else
inline constexpr bool kGuardsPrograms = true;
#endif

/// Why a program's code was left: a signal, or the time limit, for which `signal` is 0.
struct Interruption {
  int signal = 0;
  int code = 0;
  std::uintptr_t address = 0;
  std::uintptr_t instruction = 0;
};

/// A range of addresses.
struct CodeRange {
  std::uintptr_t begin = 0;
  std::uintptr_t end = 0;
  bool holds(std::uintptr_t address) const { return address >= begin && address < end; }
};

/// What signal handlers must know of a program. When its code raises one of the signals SIGSEGV, SIGBUS,
/// SIGFPE, SIGILL and SIGABRT, the handler leaves it: `ended` is called on the program's stack, from whose
/// top everything is forgotten, and must not return. Signals that come while the emulator's own code runs, or
/// no program, go to the handlers that were there before.
///
/// What is left so is left where it stands: destructors do not run, and a lock that the C library held for
/// the program (inside printf) stays taken. The time limit therefore waits for an instruction of the program
/// itself, and interrupts library functions only after two seconds more.
struct ProgramGuard {
  using Ended = void (*)(void* program);

  ProgramGuard(std::byte* stack_top, Ended ended, void* program);

  /// True while the program's own code runs, and not that of the emulator in its behalf.
  std::atomic<bool> in_program{false};
  std::byte* const stack_top;
  const Ended ended;
  void* const program;
  CodeRange code;
  /// Whether errors are the program's end; if not, only the time limit is.
  bool contains_errors = true;
  Interruption what;

 private:
  friend class GuardScope;
  friend struct GuardSignals;
  using Time = std::chrono::steady_clock::time_point;

  static constexpr std::size_t kSignalStack = 64 * 1024;
  /// Handlers run here: a program that has used up its stack has no room for them.
  std::unique_ptr<std::byte[]> signal_stack_;
  Time deadline_ = Time::max();
};

/// While it lives, signals of this thread may be those of the program's code. The handlers are put in place
/// by the first one of the process; who installs others later should hand on to them what is not his.
class GuardScope {
 public:
  GuardScope(ProgramGuard& guard, ProgramGuard::Time deadline);
  ~GuardScope();
  GuardScope(const GuardScope&) = delete;
  GuardScope& operator=(const GuardScope&) = delete;

 private:
  void start_timer(ProgramGuard::Time deadline);

  ProgramGuard* const outer_;
  stack_t stack_before_{};
  sigset_t mask_before_{};
  std::optional<timer_t> timer_;
};

/// For the emulator's own code on a program's stack: signals are not the program's meanwhile.
class OutsideProgram {
 public:
  explicit OutsideProgram(ProgramGuard& guard) : guard_(guard) {
    guard_.in_program.store(false, std::memory_order_relaxed);
    std::atomic_signal_fence(std::memory_order_seq_cst);
  }
  ~OutsideProgram() {
    std::atomic_signal_fence(std::memory_order_seq_cst);
    guard_.in_program.store(true, std::memory_order_relaxed);
  }
  OutsideProgram(const OutsideProgram&) = delete;
  OutsideProgram& operator=(const OutsideProgram&) = delete;

 private:
  ProgramGuard& guard_;
};

}  // namespace spu_emu

#endif
