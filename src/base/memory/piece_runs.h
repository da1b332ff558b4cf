/// @file
/// Which pieces of a region of memory are given out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace cellsweep {

/// A region in runs of pieces, given out or free, one behind the other. What is asked for gets the first free
/// run that is long enough. One thread at a time.
class PieceRuns {
 public:
  static constexpr std::uint32_t kPieces = 2048;
  static constexpr std::uint32_t kPiecesOfPage = 128;  ///< of a huge page
  static constexpr std::uint32_t kPages = kPieces / kPiecesOfPage;

  PieceRuns() { set(0, kPieces, 0); }

  /// The first of so many pieces, a multiple of `unit`; kPieces where there is no room for them.
  [[gnu::cold]] std::uint32_t take(std::uint32_t pieces, std::uint32_t unit);
  /// Makes a run longer, where what is behind it is free, or shorter. False when it stays as long as it is.
  [[gnu::cold]] bool resize(std::uint32_t first, std::uint32_t pieces);
  void give(std::uint32_t first) { set(first, length(first), 0); }
  /// Where a run that was given out ends.
  std::uint32_t end_of(std::uint32_t first) const { return first + length(first); }

  /// The pages in which nothing is given out, a bit each.
  [[gnu::cold]] std::uint32_t free_pages() const;

 private:
  static constexpr std::uint16_t kGivenOut = 0x8000;

  bool is_free(std::uint32_t first) const { return (runs_[first] & kGivenOut) == 0; }
  std::uint32_t length(std::uint32_t first) const { return runs_[first] & ~std::uint32_t{kGivenOut}; }
  void set(std::uint32_t first, std::uint32_t pieces, std::uint16_t flag) {
    if (pieces > 0) runs_[first] = static_cast<std::uint16_t>(pieces | flag);
  }
  void unite_free(std::uint32_t first);

  std::array<std::uint16_t, kPieces> runs_{};  // where one begins: how long it is, and kGivenOut
};

}  // namespace cellsweep
