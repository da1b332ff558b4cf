/// @file
/// Pair keys that grow: what the kernels write into.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "engines/stream/kernels/kernel.h"

namespace cellsweep::stream {

/// A KeyBuffer that owns its memory.
class Keys {
 public:
  Keys();
  Keys(const Keys&) = delete;
  Keys& operator=(const Keys&) = delete;
  Keys& operator=(Keys&& other) noexcept;
  ~Keys();

  KeyBuffer& buffer() { return buffer_; }
  std::span<const std::uint64_t> view() const { return {buffer_.keys, buffer_.size}; }
  std::size_t bytes() const { return buffer_.capacity * sizeof(std::uint64_t); }
  /// Empties it; gives memory back when there was use for little of it.
  void clear();

 private:
  KeyBuffer buffer_;
};

}  // namespace cellsweep::stream
