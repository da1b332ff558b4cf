#include "cellsweep/world/frame_file.h"

#include <utility>

#include "geometry/bounds.h"
#include "world/files/recorded_frames.h"
#include "world/recording_frames.h"

namespace cellsweep {

using InMemory = std::shared_ptr<const Recording>;
using InFile = std::shared_ptr<const RecordedFrames>;
using Changes = std::shared_ptr<const Trace>;

FrameFile::FrameFile(Recording recording)
    : content_(std::make_shared<const Recording>(std::move(recording))) {}
FrameFile::FrameFile(RecordedFrames recorded)
    : content_(std::make_shared<const RecordedFrames>(std::move(recorded))) {}
FrameFile::FrameFile(Trace trace) : content_(std::make_shared<const Trace>(std::move(trace))) {}

std::size_t FrameFile::ids() const {
  if (const auto* recording = std::get_if<InMemory>(&content_)) return (*recording)->bodies;
  if (const auto* recorded = std::get_if<InFile>(&content_)) return (*recorded)->bodies();
  return std::get<Changes>(content_)->ids();
}

std::size_t FrameFile::frames() const {
  return std::visit([](const auto& content) { return content->frames(); }, content_);
}

Aabb FrameFile::world() const {
  if (const auto* recording = std::get_if<InMemory>(&content_)) return (*recording)->world;
  if (const auto* recorded = std::get_if<InFile>(&content_)) return (*recorded)->world();
  Bounds bounds;
  const Trace& trace = *std::get<Changes>(content_);
  for (const Aabb& box : trace.inserted_boxes) bounds.include(box);
  for (const Aabb& box : trace.moved_boxes) bounds.include(box);
  return bounds.box();
}

Status FrameFile::for_each_box(const std::function<void(const Aabb&)>& look) const {
  if (const auto* recorded = std::get_if<InFile>(&content_)) return (*recorded)->for_each_box(look);
  if (const auto* recording = std::get_if<InMemory>(&content_)) {
    for (const Aabb& box : (*recording)->boxes) look(box);
    return {};
  }
  const Trace& trace = *std::get<Changes>(content_);
  for (const Aabb& box : trace.inserted_boxes) look(box);
  for (const Aabb& box : trace.moved_boxes) look(box);
  return {};
}

std::unique_ptr<FrameSource> FrameFile::make_source() const {
  if (const auto* recording = std::get_if<InMemory>(&content_)) return make_recording_frames(*recording);
  if (const auto* recorded = std::get_if<InFile>(&content_)) return make_recorded_frames(*recorded);
  return make_trace_frames(std::get<Changes>(content_));
}

Result<FrameFile> read_frame_file(const std::filesystem::path& path) {
  if (path.extension() == ".npz") {
    Result<Trace> trace = read_trace(path);
    if (!trace) return trace.status();
    return FrameFile(std::move(*trace));
  }
  Result<RecordedFrames> recorded = RecordedFrames::open(path);
  if (!recorded) return recorded.status();
  if (Status status = recorded->check(); !status.ok()) return status;
  return FrameFile(std::move(*recorded));
}

}  // namespace cellsweep
