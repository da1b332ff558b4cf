/// @file
/// What the system has memory for.
#pragma once

#ifdef __linux__

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cellsweep {

/// How many whole pages between these it has memory for.
inline std::size_t pages_there(const std::byte* from, const std::byte* to) {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t first = (reinterpret_cast<std::uintptr_t>(from) + page - 1) / page * page;
  std::vector<unsigned char> there((reinterpret_cast<std::uintptr_t>(to) - first) / page);
  EXPECT_EQ(mincore(reinterpret_cast<void*>(first), there.size() * page, there.data()), 0);
  return static_cast<std::size_t>(std::ranges::count_if(there, [](unsigned char is) { return is & 1U; }));
}

}  // namespace cellsweep

#endif
