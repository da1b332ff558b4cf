#include "app/frame_range.h"

#include <array>
#include <cstdio>
#include <istream>

#include "base/text.h"

namespace cellsweep::app {

std::istream& operator>>(std::istream& stream, FrameRange& range) {
  FrameRange read;
  char colon = 0;
  if (!(stream >> read.first >> colon >> read.last) || colon != ':' || !read.given()) {
    stream.setstate(std::ios::failbit);
    return stream;
  }
  range = read;
  return stream;
}

std::string numbered_png(std::size_t frame) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "%05zu.png", frame);
  return name.data();
}

Status unreached_frame_status(std::size_t wanted, std::size_t last) {
  return Status::bad_input(text("Frame ", wanted, " was to be drawn, but the last frame is ", last, "."),
                           "frame", wanted, last);
}

}  // namespace cellsweep::app
