/// @file
/// Blocks of middle size, in regions of huge pages that stay the process's.
#pragma once

#include <cstddef>

namespace cellsweep::regions {

/// The C library gives such blocks back to the system, and the next one, of another engine or of the next
/// update, waits for each of its pages: 10,000 stacked cubes in an engine that is made anew for each frame
/// took more than five times as long (EPYC, Linux as a guest). Here the pages of what was given back are
/// those of the next blocks, up to kMostIdle bytes of them. All functions are safe to call from any thread,
/// and in a child of fork().
inline constexpr std::size_t kLeast = std::size_t{64} << 10;
inline constexpr std::size_t kMost = std::size_t{8} << 20;
inline constexpr std::size_t kMostIdle = std::size_t{64} << 20;
/// What the system is asked for at a time, of which it gets back what is not in whole huge pages.
inline constexpr std::size_t kAskedAtOnce = std::size_t{34} << 20;

/// Uninitialised memory for kLeast to kMost bytes, aligned to 16 KB, from a huge page on to huge pages; null
/// where there is none.
[[gnu::cold]] std::byte* take(std::size_t bytes);
/// The same block may have so many bytes, more or fewer, up to kMost. False when it stays as it is: where it
/// is not from here, or has no room to grow.
[[gnu::cold]] bool resize(std::byte* memory, std::size_t bytes);
/// False when the block is not from here.
[[gnu::cold]] bool give(void* memory);

}  // namespace cellsweep::regions
