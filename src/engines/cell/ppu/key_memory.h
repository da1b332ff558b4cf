/// @file
/// Main memory for as many keys as an SPU might send: reserved, but only touched where keys arrive.
#pragma once

#include <cstdint>
#include <memory>
#include <new>

#include "engines/cell/wire.h"

namespace cellsweep::cell {

/// Uninitialised words that begin at a DMA line. Large blocks cost address space, not memory.
class KeyMemory {
 public:
  /// At least so many words from now on; what was in it is lost when it grows.
  void reserve(std::uint64_t words) {
    if (words <= words_) return;
    memory_.reset();
    const std::uint64_t bytes = (words * 4 + kDmaAlign - 1) / kDmaAlign * kDmaAlign;
    memory_.reset(static_cast<std::uint32_t*>(::operator new (bytes, std::align_val_t{kDmaAlign})));
    words_ = words;
  }

  const std::uint32_t* data() const { return memory_.get(); }

 private:
  struct Free {
    void operator()(std::uint32_t* memory) const { ::operator delete (memory, std::align_val_t{kDmaAlign}); }
  };

  std::unique_ptr<std::uint32_t[], Free> memory_;
  std::uint64_t words_ = 0;
};

}  // namespace cellsweep::cell
