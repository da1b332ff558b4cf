/// @file
/// Frames by number: a range on the command line, and what is said when there are not so many.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>

#include "cellsweep/status.h"
#include "cellsweep/world/frame_source.h"

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

/// Goes on from frame `at` to a later one; on a terminal one sees how far `what` has come. Errors: bad_input
/// when there are not so many frames, and those of the source.
Status go_to_frame(FrameSource& source, std::size_t& at, std::size_t frame, const std::string& what);

}  // namespace cellsweep::app
