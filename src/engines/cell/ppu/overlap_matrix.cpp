#include "engines/cell/ppu/overlap_matrix.h"

#include <algorithm>

namespace cellsweep::cell {

void OverlapMatrix::grow(std::uint32_t slots) {
  const std::size_t stride = slots / 32;
  std::vector<std::uint32_t> words(stride * slots);
  for (std::size_t row = 0; row < stride_ * 32; ++row) {
    std::copy_n(words_.begin() + static_cast<std::ptrdiff_t>(row * stride_), stride_,
                words.begin() + static_cast<std::ptrdiff_t>(row * stride));
  }
  stride_ = stride;
  words_.swap(words);
}

}  // namespace cellsweep::cell
