#include "world/files/recorded_trace.h"

#include <utility>

#include "geometry/bounds.h"
#include "world/files/trace_reader.h"
#include "world/files/whole_file.h"

namespace cellsweep {
namespace {

/// The file may be another by now than it was when all of it was looked at: what is read is checked again,
/// and must be what the summary says.
class PartsInFile final : public TraceParts {
 public:
  explicit PartsInFile(std::shared_ptr<const RecordedTrace> recorded) : recorded_(std::move(recorded)) {
    auto reader = recorded_->open_reader();
    status_ = reader.status();
    if (reader) reader_ = std::move(*reader);
    if (reader_ && (reader_->has_filters() != recorded_->summary().has_filters ||
                    reader_->frames() != recorded_->frames()))
      status_ = is_another();
  }

  std::optional<TracePart> next() override {
    if (!status_.ok() || !reader_->has_more()) return std::nullopt;
    status_ = reader_->next(next_);
    if (!status_.ok()) {
      status_ = refusal_of_file(recorded_->path(), status_.message);
    } else if (!fits()) {
      status_ = is_another();
    }
    if (!status_.ok()) return std::nullopt;
    is_first_ = false;
    std::swap(now_, next_);
    return now_.part();
  }

  Status status() const override { return status_; }

 private:
  bool fits() const {
    const bool all_stay = next_.inserted.empty() && next_.removed.empty();
    return reader_->ids() <= recorded_->ids() &&
           (is_first_ || all_stay || recorded_->summary().bodies_come_and_go);
  }

  Status is_another() const {
    return refusal_of_file(recorded_->path(), "has changed since it was looked at");
  }

  std::shared_ptr<const RecordedTrace> recorded_;
  std::unique_ptr<TraceReader> reader_;
  bool is_first_ = true;
  TraceFrame now_;   // handed out
  TraceFrame next_;  // being read
  Status status_;
};

}  // namespace

Result<std::unique_ptr<TraceReader>> RecordedTrace::open_reader() const {
  Result<std::unique_ptr<TraceReader>> reader = TraceReader::open(file_);
  if (!reader) return refusal_of_file(path(), reader.status().message);
  return reader;
}

Status RecordedTrace::for_each_part(const std::function<void(const TracePart&)>& look) const {
  const auto reader = open_reader();
  if (!reader) return reader.status();
  TraceFrame frame;
  while ((*reader)->has_more()) {
    if (Status status = (*reader)->next(frame); !status.ok()) return refusal_of_file(path(), status.message);
    look(frame.part());
  }
  return {};
}

Status RecordedTrace::for_each_box(const std::function<void(const Aabb&)>& look) const {
  return for_each_part([&](const TracePart& part) {
    for (const Aabb& box : part.inserted_boxes) look(box);
    for (const Aabb& box : part.moved_boxes) look(box);
  });
}

Result<RecordedTrace> RecordedTrace::open(const std::filesystem::path& path) {
  if (path.extension() != ".npz") return refusal_of_file(path, "expected a name that ends in .npz");
  auto file = InputFile::open(path);
  if (!file) return file.status();
  RecordedTrace recorded;
  recorded.file_ = std::move(*file);
  recorded.summary_.name = path.stem().string();
  const auto reader = recorded.open_reader();
  if (!reader) return reader.status();
  Bounds bounds;
  TraceFrame frame;
  while ((*reader)->has_more()) {
    if (Status status = (*reader)->next(frame); !status.ok()) return refusal_of_file(path, status.message);
    for (const Aabb& box : frame.inserted_boxes) bounds.include(box);
    for (const Aabb& box : frame.moved_boxes) bounds.include(box);
    if (recorded.frames_++ > 0 && !(frame.inserted.empty() && frame.removed.empty()))
      recorded.summary_.bodies_come_and_go = true;
  }
  recorded.summary_.ids = (*reader)->ids();
  recorded.summary_.has_filters = (*reader)->has_filters();
  recorded.world_ = bounds.box();
  return recorded;
}

std::unique_ptr<FrameSource> make_trace_frames(std::shared_ptr<const RecordedTrace> recorded) {
  TraceSummary summary = recorded->summary();
  return make_trace_frames(std::move(summary), std::make_unique<PartsInFile>(std::move(recorded)));
}

}  // namespace cellsweep
