/// @file
/// What must hold of a trace.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "cellsweep/world/trace.h"

namespace cellsweep {

/// Which element of which list is wrong, and how.
struct TraceFault {
  std::string_view list;
  std::size_t index = 0;
  std::size_t frame = 0;
  std::string expected;
  std::string found;
};

/// The first fault of a trace whose boxes are good; nothing when it holds together.
std::optional<TraceFault> find_fault(const Trace& trace);

}  // namespace cellsweep
