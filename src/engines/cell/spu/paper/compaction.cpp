#include "engines/cell/spu/paper/compaction.h"

namespace cellsweep::cell::paper {
namespace {

/// Hoare's partition: returns a place such that no word before it is below any word from it on. Stops at
/// equal words, so that an array of sentinels only is cut in halves.
std::uint32_t partition(std::int32_t* words, std::uint32_t count) {
  const std::int32_t pivot = words[(count - 1) / 2];
  std::uint32_t left = 0;
  std::uint32_t right = count - 1;
  for (;;) {
    while (words[left] > pivot) ++left;
    while (words[right] < pivot) --right;
    if (left >= right) return right + 1;
    const std::int32_t word = words[left];
    words[left++] = words[right];
    words[right--] = word;
  }
}

}  // namespace

// Only the smaller part is left to a further call, so that the stack holds few of them.
void reverse_quicksort(std::int32_t* words, std::uint32_t count) {
  while (count > 1) {
    const std::uint32_t first_part = partition(words, count);
    const std::uint32_t second_part = count - first_part;
    if (first_part < second_part) {
      reverse_quicksort(words, first_part);
      words += first_part;
      count = second_part;
    } else {
      reverse_quicksort(words + first_part, second_part);
      count = first_part;
    }
  }
}

std::uint32_t remove_duplicates(std::int32_t* words, std::uint32_t count, std::int32_t sentinel) {
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < count && words[i] != sentinel; ++i) {
    if (kept == 0 || words[kept - 1] != words[i]) words[kept++] = words[i];
  }
  return kept;
}

}  // namespace cellsweep::cell::paper
