/// @file
/// A signal notification register: one 32-bit word that others write and the SPU reads and clears.
#ifndef SPU_EMU_MFC_SIGNAL_H
#define SPU_EMU_MFC_SIGNAL_H

#include <atomic>
#include <cstdint>
#include <mutex>

namespace spu_emu {

enum class SignalMode { overwrite, logical_or };

/// Any thread may write and read.
class SignalRegister {
 public:
  explicit SignalRegister(SignalMode mode) : mode_(mode) {}

  /// Sets the word, or ORs into it, by the mode; a word of 0 counts as a signal too.
  void write(std::uint32_t value);
  /// False when nothing was written since the last read; else the word, which is 0 afterwards.
  bool try_read(std::uint32_t& value);
  /// The word as it is, unread.
  std::uint32_t value() const {
    const std::lock_guard lock(mutex_);
    return value_;
  }
  SignalMode mode() const { return mode_; }
  bool pending() const { return pending_.load(std::memory_order_acquire); }

 private:
  const SignalMode mode_;
  mutable std::mutex mutex_;
  std::uint32_t value_ = 0;
  std::atomic<bool> pending_{false};
};

}  // namespace spu_emu

#endif
