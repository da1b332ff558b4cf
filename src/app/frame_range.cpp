#include "app/frame_range.h"

#include <array>
#include <cstdio>
#include <istream>

#include "base/text.h"
#include "report/progress.h"

namespace cellsweep::app {
namespace {

Status unreached_frame_status(std::size_t wanted, std::size_t last) {
  return Status::bad_input(text("Frame ", wanted, " was asked for, but the last frame is ", last, "."),
                           "frame", wanted, last);
}

}  // namespace

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

Status go_to_frame(FrameSource& source, std::size_t& at, std::size_t frame, const std::string& what) {
  if (Status status = source.status(); !status.ok()) return status;
  report::Progress progress(what + ", on the way to frame", frame);
  for (; at < frame; ++at) {
    if (!source.advance()) return source.status().ok() ? unreached_frame_status(frame, at) : source.status();
    progress.show(at);
  }
  return {};
}

}  // namespace cellsweep::app
