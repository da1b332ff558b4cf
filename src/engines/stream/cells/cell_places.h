/// @file
/// A counting sort by cell, for where few of many cells come up.
#pragma once

#include <cstdint>
#include <span>

#include "base/memory/arena.h"

namespace cellsweep::stream {

/// Places for what is put into cells, ascending by cell: first each worker counts what it has, and then puts
/// it there in the same order. Of a cell into which nothing comes no more than a bit is looked at.
class CellPlaces {
 public:
  /// The places of a cell into which something comes.
  struct Run {
    std::uint32_t cell;
    std::uint32_t first;
    std::uint32_t count;
  };

  /// What one worker counts, and where it puts that.
  class OfWorker {
   public:
    OfWorker(std::uint32_t* numbers, std::uint64_t* used) : numbers_(numbers), used_(used) {}

    void count(std::uint32_t cell) {
      ++numbers_[cell];
      used_[cell / kBits] |= std::uint64_t{1} << cell % kBits;
    }
    /// After lay_out(): the next place in this cell.
    std::uint32_t next(std::uint32_t cell) { return numbers_[cell]++; }

   private:
    std::uint32_t* numbers_;  // by cell: how much comes into it, then the next place
    std::uint64_t* used_;     // a bit for each cell that comes up
  };

  /// Nothing is counted. The memory is the scratch's.
  CellPlaces(Arena& scratch, unsigned workers, std::uint32_t cells);

  OfWorker of(unsigned worker) {
    return {numbers_ + std::size_t{worker} * cells_, used_ + std::size_t{worker} * step_};
  }

  /// After all have counted: numbers the places. Returns how many there are; where 32 bits do not hold that,
  /// they mean nothing.
  std::uint64_t lay_out();
  /// Ascending by cell.
  std::span<const Run> runs() const { return runs_; }

 private:
  static constexpr std::uint32_t kBits = 64;

  std::uint64_t used_of_all(std::uint32_t word) const;
  std::uint32_t number_cell(std::uint32_t cell, std::uint32_t first);

  Arena& scratch_;
  unsigned workers_;
  std::uint32_t cells_;
  std::uint32_t words_;     // of bits, of one worker
  std::uint32_t step_;      // from those to the next one's
  std::uint32_t* numbers_;  // of one worker after the other
  std::uint64_t* used_;
  std::span<const Run> runs_{};
};

}  // namespace cellsweep::stream
