#include "cellsweep/world/frame_file.h"

#include <utility>

#include "geometry/bounds.h"
#include "world/files/recorded_frames.h"
#include "world/files/recorded_trace.h"
#include "world/files/recording_writer.h"
#include "world/files/trace_writer.h"
#include "world/recording_check.h"
#include "world/recording_frames.h"
#include "world/trace_part.h"

namespace cellsweep {

using InMemory = std::shared_ptr<const Recording>;
using InFile = std::shared_ptr<const RecordedFrames>;
using Changes = std::shared_ptr<const Trace>;
using ChangesInFile = std::shared_ptr<const RecordedTrace>;

FrameFile::FrameFile(Recording recording)
    : content_(std::make_shared<const Recording>(std::move(recording))) {}
FrameFile::FrameFile(RecordedFrames recorded)
    : content_(std::make_shared<const RecordedFrames>(std::move(recorded))) {}
FrameFile::FrameFile(RecordedTrace recorded)
    : content_(std::make_shared<const RecordedTrace>(std::move(recorded))) {}
FrameFile::FrameFile(Trace trace) : content_(std::make_shared<const Trace>(std::move(trace))) {}

std::size_t FrameFile::ids() const {
  if (const auto* recording = std::get_if<InMemory>(&content_)) return (*recording)->bodies;
  if (const auto* recorded = std::get_if<InFile>(&content_)) return (*recorded)->bodies();
  if (const auto* recorded = std::get_if<ChangesInFile>(&content_)) return (*recorded)->ids();
  return std::get<Changes>(content_)->ids();
}

std::size_t FrameFile::frames() const {
  return std::visit([](const auto& content) { return content->frames(); }, content_);
}

Aabb FrameFile::world() const {
  if (const auto* recording = std::get_if<InMemory>(&content_)) return (*recording)->world;
  if (const auto* recorded = std::get_if<InFile>(&content_)) return (*recorded)->world();
  if (const auto* recorded = std::get_if<ChangesInFile>(&content_)) return (*recorded)->world();
  Bounds bounds;
  const Trace& trace = *std::get<Changes>(content_);
  for (const Aabb& box : trace.inserted_boxes) bounds.include(box);
  for (const Aabb& box : trace.moved_boxes) bounds.include(box);
  return bounds.box();
}

Status FrameFile::for_each_box(const std::function<void(const Aabb&)>& look) const {
  if (const auto* recorded = std::get_if<InFile>(&content_)) return (*recorded)->for_each_box(look);
  if (const auto* recorded = std::get_if<ChangesInFile>(&content_)) return (*recorded)->for_each_box(look);
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
  if (const auto* recorded = std::get_if<ChangesInFile>(&content_)) return make_trace_frames(*recorded);
  return make_trace_frames(std::get<Changes>(content_));
}

namespace {

Result<FramesWritten> write_trace_frames(FrameSource& source, std::size_t updates,
                                         const std::filesystem::path& path) {
  TraceWriter writer;
  if (Status status = writer.open(path); !status.ok()) return status;
  TraceFrame frame;
  bool more = true;
  for (std::size_t update = 0; more; ++update) {
    take_frame(source, update == 0, frame);
    if (Status status = writer.add(frame.part()); !status.ok()) return status;
    more = update < updates && source.advance();
  }
  if (Status status = source.status(); !status.ok()) return status;
  if (Status status = writer.commit(); !status.ok()) return status;
  return FramesWritten{writer.ids(), writer.frames()};
}

Result<FramesWritten> write_recording_frames(FrameSource& source, std::size_t updates, const Aabb& world,
                                             const std::filesystem::path& path) {
  if (Status status = check_fits_recording(source); !status.ok()) return status;
  const std::size_t bodies = source.boxes().size();
  RecordingWriter writer;
  if (Status status = writer.open(path, {source.name(), "", world, bodies}); !status.ok()) return status;
  bool more = true;
  for (std::size_t update = 0; more; ++update) {
    if (Status status = writer.add(source.boxes()); !status.ok()) return status;
    more = update < updates && source.advance();
  }
  if (Status status = source.status(); !status.ok()) return status;
  if (Status status = writer.commit(); !status.ok()) return status;
  return FramesWritten{bodies, writer.frames()};
}

}  // namespace

Result<FramesWritten> write_frame_file(FrameSource& source, std::size_t updates, const Aabb& world,
                                       const std::filesystem::path& path) {
  if (Status status = source.status(); !status.ok()) return status;
  if (path.extension() == ".npz") return write_trace_frames(source, updates, path);
  return write_recording_frames(source, updates, world, path);
}

Result<FrameFile> read_frame_file(const std::filesystem::path& path) {
  if (path.extension() == ".npz") {
    Result<RecordedTrace> recorded = RecordedTrace::open(path);
    if (!recorded) return recorded.status();
    return FrameFile(std::move(*recorded));
  }
  Result<RecordedFrames> recorded = RecordedFrames::open(path);
  if (!recorded) return recorded.status();
  if (Status status = recorded->check(); !status.ok()) return status;
  return FrameFile(std::move(*recorded));
}

}  // namespace cellsweep
