/// @file
/// Where the MFC tells what it does and when, for a timeline.
#ifndef SPU_EMU_MFC_ACTIVITY_H
#define SPU_EMU_MFC_ACTIVITY_H

#include <chrono>
#include <cstdint>

#include "mfc/command.h"

namespace spu_emu {

using TraceTime = std::chrono::steady_clock::time_point;

/// Receives spans that nest properly within one SPE's thread.
class ActivityLog {
 public:
  virtual ~ActivityLog() = default;
  /// A command issued at `issued` moved so many bytes (of a list, those of its elements) between `begin` and
  /// now.
  virtual void transfer(const Command& command, std::uint64_t bytes, TraceTime issued, TraceTime begin) = 0;
  /// The SPU waited for `what` from `begin` until now.
  virtual void wait(const char* what, TraceTime begin) = 0;
};

/// Reports a wait from construction to destruction; nothing if `log` is null.
class WaitSpan {
 public:
  WaitSpan(ActivityLog* log, const char* what) : log_(log), what_(what) {
    if (log_ != nullptr) begin_ = std::chrono::steady_clock::now();
  }
  ~WaitSpan() {
    if (log_ != nullptr) log_->wait(what_, begin_);
  }
  WaitSpan(const WaitSpan&) = delete;
  WaitSpan& operator=(const WaitSpan&) = delete;

 private:
  ActivityLog* log_;
  const char* what_;
  TraceTime begin_;
};

}  // namespace spu_emu

#endif
