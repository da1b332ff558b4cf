/// @file
/// Ctrl-C, and time that is up: both ask a running program to stop.
#ifndef SPU_EMU_ISA_DEBUG_INTERRUPTION_H
#define SPU_EMU_ISA_DEBUG_INTERRUPTION_H

#include <signal.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "isa/core/machine.h"

namespace spu_emu::isa {

/// Takes the process's SIGINT for one machine as long as it lives. A second Ctrl-C that comes before the
/// first was noticed ends the process, as without a debugger. Of several, the last one made gets it.
class CtrlC {
 public:
  explicit CtrlC(Machine& machine);
  ~CtrlC();
  CtrlC(const CtrlC&) = delete;
  CtrlC& operator=(const CtrlC&) = delete;

  /// True once after it came.
  bool take();

 private:
  Machine& machine_;
  struct sigaction before_ {};
};

/// Asks a machine for attention after some time.
class Timer {
 public:
  explicit Timer(Machine& machine) : machine_(machine) {}
  ~Timer() { cancel(); }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

  void start(std::chrono::milliseconds time);
  void cancel();
  /// True once after the time was up.
  bool take() { return is_up_.exchange(false); }

 private:
  void run(std::chrono::milliseconds time);

  Machine& machine_;
  std::thread thread_;
  std::mutex mutex_;
  std::condition_variable cancelled_now_;
  bool cancelled_ = false;
  std::atomic<bool> is_up_{false};
};

}  // namespace spu_emu::isa

#endif
