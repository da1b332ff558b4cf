/// @file
/// Pair keys that grow: what the kernels write into.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "cellsweep/engine/engine.h"
#include "engines/stream/kernels/kernel.h"

namespace cellsweep::stream {

/// A KeyBuffer that owns its memory. With filters, pairs that these do not allow take none for long: before
/// it grows, they are left out.
class Keys : private KeyBuffer {
 public:
  Keys();
  Keys(const Keys&) = delete;
  Keys& operator=(const Keys&) = delete;
  Keys& operator=(Keys&& other) noexcept;
  ~Keys();

  KeyBuffer& buffer() { return *this; }
  std::span<const std::uint64_t> view() const { return {keys, size}; }
  std::size_t bytes() const { return capacity * sizeof(std::uint64_t); }
  /// Empties it; gives memory back when there was use for little of it.
  void clear();
  /// Empties it and gives all memory back.
  [[gnu::cold]] void give_back();

  /// From now on pairs must be allowed by these filters, by slot; none: all are.
  void allow(std::span<const BodyFilter> filters) { filters_ = filters; }
  /// Leaves out what is not allowed of what was written since the last call.
  void leave_out();
  /// Leaves out those of slots whose entry in `marked`, by slot, is not 0.
  void leave_out(const std::uint8_t* marked);
  /// More, which are allowed.
  [[gnu::cold]] void append(std::span<const std::uint64_t> more);
  /// Keeps the first `count`.
  void shrink(std::size_t count);

 private:
  static void make_more_room(KeyBuffer& buffer, std::size_t more);

  std::span<const BodyFilter> filters_;
  std::size_t allowed_ = 0;  // so many from the first on
};

}  // namespace cellsweep::stream
