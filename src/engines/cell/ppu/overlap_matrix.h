/// @file
/// Which bodies overlap which, one bit for each ordered pair of slots.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cellsweep/engine/engine.h"

namespace cellsweep::cell {

/// A symmetric matrix of bits in rows of words; the bit of column j is 31 − (j mod 32) of word j / 32.
class OverlapMatrix {
 public:
  /// Room for so many slots, a multiple of 32; what is set stays.
  void grow(std::uint32_t slots);

  /// The slots that there is room for.
  std::uint32_t slots() const { return static_cast<std::uint32_t>(stride_ * 32); }

  /// Memory held.
  std::size_t bytes() const { return words_.capacity() * sizeof(std::uint32_t); }

  /// Sets the bits of two slots in each other's rows.
  void set(Slot one, Slot other) {
    word(one, other) |= bit(other);
    word(other, one) |= bit(one);
  }

  void reset(Slot one, Slot other) {
    word(one, other) &= ~bit(other);
    word(other, one) &= ~bit(one);
  }

  bool test(Slot row, Slot column) const {
    return (words_[std::size_t{row} * stride_ + column / 32] & bit(column)) != 0;
  }

  /// Makes `row` the row of `slot`, and its column accordingly; calls change(other, now) for every bit but
  /// its own that differs.
  template <class Change>
  void replace_row(Slot slot, std::span<const std::uint32_t> row, Change&& change);

  /// Clears everything; calls visit(row, column) for every bit that was set below the diagonal, row by row,
  /// the columns ascending.
  template <class Visit>
  void drain(Visit&& visit);

  /// Clears the row and the column of a slot; calls ended(other) for every bit that was set.
  template <class Ended>
  void clear(Slot slot, Ended&& ended);

 private:
  std::uint32_t& word(Slot row, Slot column) { return words_[std::size_t{row} * stride_ + column / 32]; }
  static std::uint32_t bit(Slot column) { return std::uint32_t{0x80000000} >> (column % 32); }

  std::size_t stride_ = 0;  // words a row
  std::vector<std::uint32_t> words_;
  std::vector<std::uint32_t> nothing_;  // an empty row
};

template <class Change>
void OverlapMatrix::replace_row(Slot slot, std::span<const std::uint32_t> row, Change&& change) {
  for (std::size_t i = 0; i < row.size(); ++i) {
    std::uint32_t differing = row[i] ^ words_[slot * stride_ + i];
    if (i == slot / 32) differing &= ~bit(slot);
    while (differing != 0) {
      const Slot other = static_cast<Slot>(i * 32) + static_cast<Slot>(__builtin_clz(differing));
      differing &= ~bit(other);
      word(slot, other) ^= bit(other);
      word(other, slot) ^= bit(slot);
      change(other, (row[i] & bit(other)) != 0);
    }
  }
}

template <class Visit>
void OverlapMatrix::drain(Visit&& visit) {
  for (std::size_t i = 0; i < words_.size(); ++i) {
    const auto row = static_cast<Slot>(i / stride_);
    const auto first_column = static_cast<Slot>(i % stride_ * 32);
    while (words_[i] != 0) {
      const Slot column = first_column + static_cast<Slot>(__builtin_clz(words_[i]));
      words_[i] &= ~bit(column);
      if (column < row) visit(row, column);
    }
  }
}

template <class Ended>
void OverlapMatrix::clear(Slot slot, Ended&& ended) {
  nothing_.resize(stride_);
  replace_row(slot, nothing_, [&](Slot other, bool) { ended(other); });
}

}  // namespace cellsweep::cell
