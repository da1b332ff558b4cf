#include "base/memory/piece_runs.h"

namespace cellsweep {

// With the free ones behind it, which are left apart until somebody comes by.
void PieceRuns::unite_free(std::uint32_t first) {
  std::uint32_t end = first + length(first);
  while (end < kPieces && is_free(end)) end += length(end);
  set(first, end - first, 0);
}

std::uint32_t PieceRuns::take(std::uint32_t pieces, std::uint32_t unit) {
  for (std::uint32_t run = 0; run < kPieces; run += length(run)) {
    if (!is_free(run)) continue;
    unite_free(run);
    const std::uint32_t end = run + length(run);
    const std::uint32_t first = (run + unit - 1) / unit * unit;
    if (first + pieces > end) continue;
    set(run, first - run, 0);
    set(first, pieces, kGivenOut);
    set(first + pieces, end - first - pieces, 0);
    return first;
  }
  return kPieces;
}

bool PieceRuns::resize(std::uint32_t first, std::uint32_t pieces) {
  std::uint32_t end = first + length(first);
  if (end < kPieces && is_free(end)) {
    unite_free(end);
    end += length(end);
  }
  if (first + pieces > end) return false;
  set(first, pieces, kGivenOut);
  set(first + pieces, end - first - pieces, 0);
  return true;
}

std::uint32_t PieceRuns::free_pages() const {
  std::uint32_t pages = (1U << kPages) - 1;
  for (std::uint32_t run = 0; run < kPieces; run += length(run)) {
    if (is_free(run)) continue;
    const std::uint32_t last = (run + length(run) - 1) / kPiecesOfPage;
    for (std::uint32_t page = run / kPiecesOfPage; page <= last; ++page) pages &= ~(1U << page);
  }
  return pages;
}

}  // namespace cellsweep
