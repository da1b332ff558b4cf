/// @file
/// Frames by number: a range on the command line, and what is said when there are not so many.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

#include "cellsweep/status.h"

namespace cellsweep::app {

/// Frames first to last, both included.
struct FrameRange {
  std::size_t first = 1;
  std::size_t last = 0;

  bool given() const { return first <= last; }
  std::size_t count() const { return given() ? last - first + 1 : 0; }
};

/// Reads "A:B" with A <= B; anything else fails the stream.
std::istream& operator>>(std::istream& stream, FrameRange& range);

/// The name of a frame's picture in a sequence: "00012.png".
std::string numbered_png(std::size_t frame);

/// The status for a frame beyond the last one of a source.
Status unreached_frame_status(std::size_t wanted, std::size_t last);

}  // namespace cellsweep::app
