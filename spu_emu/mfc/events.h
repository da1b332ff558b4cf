/// @file
/// The SPU's event bits: raised by the MFC, the mailboxes and the signals, read and acknowledged by the SPU.
#ifndef SPU_EMU_MFC_EVENTS_H
#define SPU_EMU_MFC_EVENTS_H

#include <atomic>
#include <cstdint>

#include "mfc/wait_point.h"

namespace spu_emu {

/// `raise` may be called from any thread, the rest by the SPU's own. Bits: MFC_..._EVENT of mfc_opcodes.h.
class Events {
 public:
  explicit Events(WaitPoint& changed) : changed_(changed) {}

  /// Sets pending bits, masked out or not, and wakes a waiting SPU.
  void raise(std::uint32_t bits) {
    pending_.fetch_or(bits);
    changed_.notify();
  }
  /// Sets pending bits on the SPU's own behalf: nobody is waiting who would have to be woken.
  void raise_own(std::uint32_t bits) {
    if ((pending_.load(std::memory_order_relaxed) & bits) != bits) pending_.fetch_or(bits);
  }
  void acknowledge(std::uint32_t bits) { pending_.fetch_and(~bits); }
  void set_mask(std::uint32_t mask) { mask_ = mask; }
  std::uint32_t mask() const { return mask_; }
  /// Pending bits, whatever the mask says.
  std::uint32_t pending() const { return pending_.load(); }
  /// Pending bits that the mask lets through.
  std::uint32_t status() const { return pending_.load() & mask_; }

 private:
  WaitPoint& changed_;
  std::atomic<std::uint32_t> pending_{0};
  std::uint32_t mask_ = 0;
};

}  // namespace spu_emu

#endif
