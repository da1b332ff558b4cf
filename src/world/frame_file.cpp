#include "cellsweep/world/frame_file.h"

#include <utility>

#include "geometry/bounds.h"
#include "world/recording_frames.h"

namespace cellsweep {

FrameFile::FrameFile(Recording recording)
    : content_(std::make_shared<const Recording>(std::move(recording))) {}
FrameFile::FrameFile(Trace trace) : content_(std::make_shared<const Trace>(std::move(trace))) {}

const Recording* FrameFile::recording() const {
  const auto* recording = std::get_if<std::shared_ptr<const Recording>>(&content_);
  return recording == nullptr ? nullptr : recording->get();
}

const Trace* FrameFile::trace() const {
  const auto* trace = std::get_if<std::shared_ptr<const Trace>>(&content_);
  return trace == nullptr ? nullptr : trace->get();
}

std::size_t FrameFile::ids() const {
  return trace() != nullptr ? trace()->ids() : recording()->bodies;
}

std::size_t FrameFile::frames() const {
  return trace() != nullptr ? trace()->frames() : recording()->frames();
}

Aabb FrameFile::world() const {
  if (recording() != nullptr) return recording()->world;
  Bounds bounds;
  for (const auto list : boxes()) {
    for (const Aabb& box : list) bounds.include(box);
  }
  return bounds.box();
}

std::array<std::span<const Aabb>, 2> FrameFile::boxes() const {
  if (recording() != nullptr) return {recording()->boxes, {}};
  return {trace()->inserted_boxes, trace()->moved_boxes};
}

std::unique_ptr<FrameSource> FrameFile::make_source() const {
  if (const auto* trace = std::get_if<std::shared_ptr<const Trace>>(&content_))
    return make_trace_frames(*trace);
  return make_recording_frames(std::get<std::shared_ptr<const Recording>>(content_));
}

Result<FrameFile> read_frame_file(const std::filesystem::path& path) {
  if (path.extension() == ".npz") {
    Result<Trace> trace = read_trace(path);
    if (!trace) return trace.status();
    return FrameFile(std::move(*trace));
  }
  Result<Recording> recording = read_recording(path);
  if (!recording) return recording.status();
  return FrameFile(std::move(*recording));
}

}  // namespace cellsweep
