#include "engines/stream/cells/cell_places.h"

#include <algorithm>
#include <bit>

namespace cellsweep::stream {
namespace {

/// From the words of one worker to those of the next: they do not share a line of the cache, or the workers
/// would wait for each other.
std::uint32_t step_for(std::uint32_t words) {
  constexpr std::uint32_t kWordsOfLine = 8;
  return (words + kWordsOfLine - 1) / kWordsOfLine * kWordsOfLine;
}

}  // namespace

CellPlaces::CellPlaces(Arena& scratch, unsigned workers, std::uint32_t cells)
    : scratch_(scratch),
      workers_(workers),
      cells_(cells),
      words_((cells + kBits - 1) / kBits),
      step_(step_for(words_)),
      numbers_(scratch.take<std::uint32_t>(std::size_t{workers} * cells_)),
      used_(scratch.take<std::uint64_t>(std::size_t{workers} * step_)) {
  std::fill_n(numbers_, std::size_t{workers_} * cells_, 0U);
  std::fill_n(used_, std::size_t{workers_} * step_, std::uint64_t{0});
}

std::uint64_t CellPlaces::used_of_all(std::uint32_t word) const {
  std::uint64_t used = 0;
  for (unsigned worker = 0; worker < workers_; ++worker) used |= used_[std::size_t{worker} * step_ + word];
  return used;
}

// The counts of a cell become the places where workers begin: prefix sums. Returns how much comes into it.
std::uint32_t CellPlaces::number_cell(std::uint32_t cell, std::uint32_t first) {
  std::uint32_t sum = 0;
  for (unsigned worker = 0; worker < workers_; ++worker) {
    std::uint32_t& number = numbers_[std::size_t{worker} * cells_ + cell];
    const std::uint32_t count = number;
    number = first + sum;
    sum += count;
  }
  return sum;
}

std::uint64_t CellPlaces::lay_out() {
  std::size_t count = 0;
  for (std::uint32_t word = 0; word < words_; ++word)
    count += static_cast<std::size_t>(std::popcount(used_of_all(word)));
  Run* const runs = scratch_.take<Run>(count);
  Run* run = runs;
  std::uint64_t sum = 0;
  for (std::uint32_t word = 0; word < words_; ++word) {
    for (std::uint64_t used = used_of_all(word); used != 0; used &= used - 1) {
      const std::uint32_t cell = word * kBits + static_cast<std::uint32_t>(std::countr_zero(used));
      const auto first = static_cast<std::uint32_t>(sum);
      *run = {cell, first, number_cell(cell, first)};
      sum += run++->count;
    }
  }
  runs_ = {runs, count};
  return sum;
}

}  // namespace cellsweep::stream
