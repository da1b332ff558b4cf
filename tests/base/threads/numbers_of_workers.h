/// @file
/// With how many workers a test runs what may be done by one or by several.
#pragma once

#include <gtest/gtest.h>

namespace cellsweep {

/// One and several. With the thread sanitizer only several: one alone is nothing that it could find fault
/// with, and the other builds have it.
inline auto numbers_of_workers() {
#if defined(CELLSWEEP_THREAD_SANITIZED_TESTS)
  return testing::Values(3U);
#else
  return testing::Values(1U, 3U);
#endif
}

}  // namespace cellsweep
