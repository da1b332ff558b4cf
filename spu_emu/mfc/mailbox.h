/// @file
/// A mailbox: a short queue of 32-bit messages between an SPU and the rest of the machine.
#ifndef SPU_EMU_MFC_MAILBOX_H
#define SPU_EMU_MFC_MAILBOX_H

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <vector>

namespace spu_emu {

/// Any thread may read and write; nothing here blocks for long. Messages are read in the order of writing.
class Mailbox {
 public:
  static constexpr unsigned kLargestCapacity = 4;

  explicit Mailbox(unsigned capacity) : capacity_(capacity) {}

  /// False when full.
  bool try_write(std::uint32_t message);
  /// What a store to the mailbox register does: when full, the newest message is lost to this one.
  void write_over(std::uint32_t message);
  /// False when empty.
  bool try_read(std::uint32_t& message);

  unsigned count() const { return count_.load(std::memory_order_acquire); }
  unsigned capacity() const { return capacity_; }
  /// The messages that nobody has read yet, the next one first; they stay.
  std::vector<std::uint32_t> messages();
  unsigned space() const { return capacity_ - count(); }

 private:
  void append(std::uint32_t message);

  const unsigned capacity_;
  std::mutex mutex_;
  std::array<std::uint32_t, kLargestCapacity> messages_{};
  unsigned first_ = 0;
  std::atomic<unsigned> count_{0};
};

}  // namespace spu_emu

#endif
