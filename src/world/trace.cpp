#include "cellsweep/world/trace.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "world/trace_frames.h"
#include "world/trace_part.h"

namespace cellsweep {
namespace {

class TraceFrames final : public FrameSource {
 public:
  TraceFrames(TraceSummary summary, std::unique_ptr<TraceParts> parts)
      : summary_(std::move(summary)), parts_(std::move(parts)), boxes_(summary_.ids) {
    if (summary_.has_filters) filters_.resize(boxes_.size());
    if (const auto first = parts_->next()) enter(*first);
  }

  std::string name() const override { return summary_.name; }
  bool bodies_come_and_go() const override { return summary_.bodies_come_and_go; }
  std::span<const Aabb> boxes() const override { return boxes_; }
  std::span<const BodyId> bodies() const override { return bodies_; }
  std::span<const BodyFilter> filters() const override { return filters_; }
  std::span<const BodyId> moved() const override { return part_.moved; }
  std::span<const BodyId> inserted() const override {
    return is_first_ ? std::span<const BodyId>() : part_.inserted;
  }
  std::span<const BodyId> removed() const override { return part_.removed; }
  Status status() const override { return parts_->status(); }

  bool advance() override {
    const auto next = parts_->next();
    if (!next) return false;
    is_first_ = false;
    enter(*next);
    return true;
  }

 private:
  void enter(const TracePart& part) {
    part_ = part;
    leave(part.removed);
    join(part);
    for (std::size_t i = 0; i < part.moved.size(); ++i) boxes_[part.moved[i]] = part.moved_boxes[i];
  }

  void leave(std::span<const BodyId> gone) {
    if (gone.empty()) return;
    next_.clear();
    std::ranges::set_difference(bodies_, gone, std::back_inserter(next_));
    std::swap(bodies_, next_);
  }

  void join(const TracePart& part) {
    const std::span<const BodyId> came = part.inserted;
    if (came.empty()) return;
    for (std::size_t i = 0; i < came.size(); ++i) boxes_[came[i]] = part.inserted_boxes[i];
    for (std::size_t i = 0; i < part.inserted_filters.size(); ++i)
      filters_[came[i]] = part.inserted_filters[i];
    next_.clear();
    std::ranges::merge(bodies_, came, std::back_inserter(next_));
    std::swap(bodies_, next_);
  }

  TraceSummary summary_;
  std::unique_ptr<TraceParts> parts_;
  TracePart part_;  // of the frame that it stands at
  bool is_first_ = true;
  std::vector<Aabb> boxes_;          // by id
  std::vector<BodyFilter> filters_;  // by id, or none
  std::vector<BodyId> bodies_;       // ascending
  std::vector<BodyId> next_;
};

class PartsInMemory final : public TraceParts {
 public:
  explicit PartsInMemory(std::shared_ptr<const Trace> trace) : trace_(std::move(trace)) {}

  std::optional<TracePart> next() override {
    if (frame_ == trace_->frames()) return std::nullopt;
    return part_of(*trace_, frame_++);
  }

 private:
  std::shared_ptr<const Trace> trace_;
  std::size_t frame_ = 0;
};

/// A frame's part of a list, or nothing of one that is empty in all frames.
template <class T>
std::span<const T> part_of_list(const std::vector<T>& list, const std::vector<std::size_t>& ends,
                                std::size_t frame) {
  if (list.empty()) return {};
  const std::size_t first = frame == 0 ? 0 : ends[frame - 1];
  return std::span(list).subspan(first, ends[frame] - first);
}

void extend(auto& list, const auto& more) {
  list.insert(list.end(), more.begin(), more.end());
}

}  // namespace

std::size_t Trace::ids() const {
  const auto largest = std::ranges::max_element(inserted);
  return largest == inserted.end() ? 0 : *largest + std::size_t{1};
}

TracePart part_of(const Trace& trace, std::size_t frame) {
  return {part_of_list(trace.inserted, trace.inserted_ends, frame),
          part_of_list(trace.inserted_boxes, trace.inserted_ends, frame),
          part_of_list(trace.inserted_filters, trace.inserted_ends, frame),
          part_of_list(trace.removed, trace.removed_ends, frame),
          part_of_list(trace.moved, trace.moved_ends, frame),
          part_of_list(trace.moved_boxes, trace.moved_ends, frame)};
}

void take_frame(const FrameSource& source, bool is_first, TraceFrame& frame) {
  const std::span<const BodyId> inserted = is_first ? source.bodies() : source.inserted();
  const std::span<const BodyId> moved = source.moved();
  frame.inserted.assign(inserted.begin(), inserted.end());
  frame.removed.assign(source.removed().begin(), source.removed().end());
  frame.moved.assign(moved.begin(), moved.end());
  frame.inserted_boxes.clear();
  frame.inserted_filters.clear();
  frame.moved_boxes.clear();
  for (const BodyId body : inserted) frame.inserted_boxes.push_back(source.boxes()[body]);
  for (const BodyId body : moved) frame.moved_boxes.push_back(source.boxes()[body]);
  if (source.filters().empty()) return;
  for (const BodyId body : inserted) frame.inserted_filters.push_back(source.filters()[body]);
}

void append(Trace& trace, const TracePart& part) {
  extend(trace.inserted, part.inserted);
  extend(trace.inserted_boxes, part.inserted_boxes);
  extend(trace.inserted_filters, part.inserted_filters);
  extend(trace.removed, part.removed);
  extend(trace.moved, part.moved);
  extend(trace.moved_boxes, part.moved_boxes);
  trace.inserted_ends.push_back(trace.inserted.size());
  trace.removed_ends.push_back(trace.removed.size());
  trace.moved_ends.push_back(trace.moved.size());
}

Trace record_trace(FrameSource& source, std::size_t updates) {
  Trace trace;
  trace.name = source.name();
  TraceFrame frame;
  take_frame(source, true, frame);
  append(trace, frame.part());
  for (std::size_t update = 0; update < updates && source.advance(); ++update) {
    take_frame(source, false, frame);
    append(trace, frame.part());
  }
  return trace;
}

std::unique_ptr<FrameSource> make_trace_frames(TraceSummary summary, std::unique_ptr<TraceParts> parts) {
  return std::make_unique<TraceFrames>(std::move(summary), std::move(parts));
}

std::unique_ptr<FrameSource> make_trace_frames(std::shared_ptr<const Trace> trace) {
  TraceSummary summary{trace->name, trace->ids(), false, !trace->inserted_filters.empty()};
  summary.bodies_come_and_go =
      !trace->removed.empty() || (trace->frames() > 0 && trace->inserted_ends[0] < trace->inserted.size());
  return make_trace_frames(std::move(summary), std::make_unique<PartsInMemory>(std::move(trace)));
}

}  // namespace cellsweep
