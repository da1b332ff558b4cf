/// @file
/// What fat boxes cost.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cellsweep::stream {

/// What an update with fat boxes had to do.
struct FatBoxWork {
  std::size_t bodies = 0;
  bool is_full = false;        ///< all fat boxes were put into cells
  std::size_t placed = 0;      ///< else so many,
  std::uint64_t compared = 0;  ///< which were compared with so many boxes of cells
  std::size_t candidates = 0;
  std::size_t pairs = 0;
  std::size_t changed_pairs = 0;  ///< that began or ended
  bool most_settle = false;       ///< where it is full: most of the bodies that moved tremble or creep
};

}  // namespace cellsweep::stream
