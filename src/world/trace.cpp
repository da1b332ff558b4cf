#include "cellsweep/world/trace.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace cellsweep {
namespace {

/// A frame's part of a list.
template <class T>
std::span<const T> part(const std::vector<T>& list, const std::vector<std::size_t>& ends, std::size_t frame) {
  if (frame >= ends.size()) return {};  // of no frames
  const std::size_t first = frame == 0 ? 0 : ends[frame - 1];
  return std::span(list).subspan(first, ends[frame] - first);
}

class TraceFrames final : public FrameSource {
 public:
  explicit TraceFrames(std::shared_ptr<const Trace> trace) : trace_(std::move(trace)), boxes_(trace_->ids()) {
    if (!trace_->inserted_filters.empty()) filters_.resize(boxes_.size());
    come_and_go_ = !trace_->removed.empty() ||
                   (trace_->frames() > 0 && trace_->inserted_ends[0] < trace_->inserted.size());
    if (trace_->frames() > 0) enter();
  }

  std::string name() const override { return trace_->name; }
  bool bodies_come_and_go() const override { return come_and_go_; }
  std::span<const Aabb> boxes() const override { return boxes_; }
  std::span<const BodyId> bodies() const override { return bodies_; }
  std::span<const BodyFilter> filters() const override { return filters_; }
  std::span<const BodyId> moved() const override { return part(trace_->moved, trace_->moved_ends, frame_); }
  std::span<const BodyId> inserted() const override {
    return frame_ == 0 ? std::span<const BodyId>() : came();
  }
  std::span<const BodyId> removed() const override {
    return part(trace_->removed, trace_->removed_ends, frame_);
  }

  bool advance() override {
    if (frame_ + 1 >= trace_->frames()) return false;
    ++frame_;
    enter();
    return true;
  }

 private:
  std::span<const BodyId> came() const { return part(trace_->inserted, trace_->inserted_ends, frame_); }

  void enter() {
    if (frame_ > 0) leave(removed());
    join(came());
    const std::span<const Aabb> boxes = part(trace_->moved_boxes, trace_->moved_ends, frame_);
    for (std::size_t i = 0; i < boxes.size(); ++i) boxes_[moved()[i]] = boxes[i];
  }

  void leave(std::span<const BodyId> gone) {
    if (gone.empty()) return;
    next_.clear();
    std::ranges::set_difference(bodies_, gone, std::back_inserter(next_));
    std::swap(bodies_, next_);
  }

  void join(std::span<const BodyId> came) {
    if (came.empty()) return;
    const std::span<const Aabb> boxes = part(trace_->inserted_boxes, trace_->inserted_ends, frame_);
    for (std::size_t i = 0; i < came.size(); ++i) boxes_[came[i]] = boxes[i];
    if (!filters_.empty()) {
      const auto filters = part(trace_->inserted_filters, trace_->inserted_ends, frame_);
      for (std::size_t i = 0; i < came.size(); ++i) filters_[came[i]] = filters[i];
    }
    next_.clear();
    std::ranges::merge(bodies_, came, std::back_inserter(next_));
    std::swap(bodies_, next_);
  }

  std::shared_ptr<const Trace> trace_;
  bool come_and_go_ = false;
  std::size_t frame_ = 0;
  std::vector<Aabb> boxes_;          // by id
  std::vector<BodyFilter> filters_;  // by id, or none
  std::vector<BodyId> bodies_;       // ascending
  std::vector<BodyId> next_;
};

void append(Trace& trace, const FrameSource& source, std::span<const BodyId> inserted) {
  for (const BodyId body : inserted) {
    trace.inserted.push_back(body);
    trace.inserted_boxes.push_back(source.boxes()[body]);
    if (!source.filters().empty()) trace.inserted_filters.push_back(source.filters()[body]);
  }
  trace.removed.insert(trace.removed.end(), source.removed().begin(), source.removed().end());
  for (const BodyId body : source.moved()) {
    trace.moved.push_back(body);
    trace.moved_boxes.push_back(source.boxes()[body]);
  }
  trace.inserted_ends.push_back(trace.inserted.size());
  trace.removed_ends.push_back(trace.removed.size());
  trace.moved_ends.push_back(trace.moved.size());
}

}  // namespace

std::size_t Trace::ids() const {
  const auto largest = std::ranges::max_element(inserted);
  return largest == inserted.end() ? 0 : *largest + std::size_t{1};
}

Trace record_trace(FrameSource& source, std::size_t updates) {
  Trace trace;
  trace.name = source.name();
  append(trace, source, source.bodies());
  for (std::size_t update = 0; update < updates && source.advance(); ++update)
    append(trace, source, source.inserted());
  return trace;
}

std::unique_ptr<FrameSource> make_trace_frames(std::shared_ptr<const Trace> trace) {
  return std::make_unique<TraceFrames>(std::move(trace));
}

}  // namespace cellsweep
