/// @file
/// Sorts many keys a part at a time, so that no call takes long.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/array.h"
#include "base/memory/list.h"

namespace cellsweep {

class SteppedSort {
 public:
  /// Takes these keys up; the list is empty then. Throws std::bad_alloc, and nothing has changed.
  [[gnu::cold]] void begin(List<std::uint64_t>& keys);

  /// Goes on for so many steps at most, of one key each, and takes away from `steps` what it went. True when
  /// all is sorted.
  bool go_on(std::size_t& steps);

  /// Ascending, after that. Valid until begin().
  std::span<const std::uint64_t> keys() const { return keys_.view(); }

  /// Gives its memory back, and forgets what is in there.
  [[gnu::cold]] void give_back();

  std::size_t bytes() const { return keys_.bytes() + sorted_.bytes() + counts_.bytes(); }

 private:
  static constexpr unsigned kDigitBits = 11;  // more counters outgrow the fastest cache
  static constexpr unsigned kDigits = (64 + kDigitBits - 1) / kDigitBits;
  static constexpr std::size_t kValues = std::size_t{1} << kDigitBits;

  static std::size_t value(std::uint64_t key, unsigned digit) {
    return (key >> (digit * kDigitBits)) & (kValues - 1);
  }
  std::uint32_t* counts(unsigned digit) { return counts_.data() + digit * kValues; }
  void count(std::span<const std::uint64_t> keys);
  bool prepare_digit();
  void distribute(std::span<const std::uint64_t> keys);
  void end_pass();

  List<std::uint64_t> keys_;    // by the digits so far
  List<std::uint64_t> sorted_;  // those before place_ by the next one, too
  /// How often each value of each digit occurs; of the digit in hand, where the next key with it goes.
  Array<std::uint32_t> counts_;
  bool is_counted_ = false;
  unsigned digit_ = kDigits;
  std::size_t place_ = 0;
};

}  // namespace cellsweep
