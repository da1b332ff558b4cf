/// @file
/// The frames of a trace, wherever its parts come from.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "cellsweep/status.h"
#include "cellsweep/world/frame_source.h"
#include "world/trace_part.h"

namespace cellsweep {

/// What is known of a trace before its first frame.
struct TraceSummary {
  std::string name;
  std::size_t ids = 0;
  bool bodies_come_and_go = false;
  bool has_filters = false;
};

/// Gives the parts of a trace one after the other.
class TraceParts {
 public:
  virtual ~TraceParts() = default;

  /// The next one, valid until the next call that gives one; nothing at the end, or where status() says why.
  /// All that the summary promises holds of it.
  virtual std::optional<TracePart> next() = 0;
  virtual Status status() const { return {}; }
};

std::unique_ptr<FrameSource> make_trace_frames(TraceSummary summary, std::unique_ptr<TraceParts> parts);

}  // namespace cellsweep
