/// @file
/// Sorts numbers that may lie anywhere.
#pragma once

#include <cstdint>
#include <span>

namespace cellsweep {

/// Ascending, by radix sort: all bits where they are few, else so many of the upper ones as tell nearly all
/// keys apart, after which a few neighbours are the wrong way round. Keys that crowd together are sorted by
/// all their bits. The keys are in `keys` afterwards or in `spare`, which is as long; returns where.
std::span<std::uint64_t> sort_keys(std::span<std::uint64_t> keys, std::span<std::uint64_t> spare);

/// How many bits the two numbers have that a key is made of, the first above the second.
struct KeyBits {
  unsigned first;
  unsigned second;

  unsigned all() const { return first + second; }
};

/// The same of such keys, several of which may have the first number in common.
std::span<std::uint64_t> sort_keys(std::span<std::uint64_t> keys, std::span<std::uint64_t> spare,
                                   KeyBits bits);

/// The same in place. Throws std::bad_alloc and has done nothing then.
void sort_keys(std::span<std::uint64_t> keys);

/// The same by insertion where they are few. False, and nothing has changed, where they are not.
bool sort_few_keys(std::span<std::uint64_t> keys);

/// A few ids or slots, ascending, in place: std::sort, compiled once.
void sort_numbers(std::span<std::uint32_t> numbers);

}  // namespace cellsweep
