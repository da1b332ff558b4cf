/// @file
/// Feeds any bytes, taken for calls, to engine `stream` and compares each answer with all against all.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>

#include "fuzz/calls.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const cellsweep::fuzz::CallsOutcome outcome = cellsweep::fuzz::make_calls(std::span(data, size));
  if (outcome.failure.empty()) return 0;
  std::fprintf(stderr, "%s\n", outcome.failure.c_str());
  std::abort();
}
