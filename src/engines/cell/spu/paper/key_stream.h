/// @file
/// Step C13: keys on their way from an SPU to main memory, a buffer at a time.
#pragma once

#include <spu_mfcio.h>

#include <cstdint>

namespace cellsweep::cell::paper {

/// Collects keys in two buffers by turns: a full one is sent while the other fills. A buffer is one chunk of
/// one command, or in list mode two chunks' worth by a DMA list. Uses the tags `first_tag` and `first_tag +
/// 1`.
class KeyStream {
 public:
  KeyStream(unsigned long long ea, bool by_list, unsigned int first_tag);
  ~KeyStream();
  KeyStream(const KeyStream&) = delete;
  KeyStream& operator=(const KeyStream&) = delete;

  void add(std::uint32_t key) {
    buffers_[turn_][filled_++] = key;
    if (filled_ == capacity_) send();
  }

  /// Sends what is left and waits until all has arrived. Returns the number of keys added.
  std::uint32_t finish();

 private:
  void send();
  void send_by_list(unsigned int bytes);

  unsigned long long ea_;
  bool by_list_;
  unsigned int first_tag_;
  unsigned int turn_ = 0;
  std::uint32_t filled_ = 0;
  std::uint32_t capacity_;
  std::uint32_t sent_ = 0;
  std::uint32_t* buffers_[2];
  mfc_list_element_t* lists_[2];
};

}  // namespace cellsweep::cell::paper
