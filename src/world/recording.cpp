#include "cellsweep/world/recording.h"

#include <utility>

#include "world/files/file_fault.h"
#include "world/recording_check.h"
#include "world/recording_frames.h"

namespace cellsweep {
namespace {

class RecordingFrames final : public FrameSource {
 public:
  explicit RecordingFrames(std::shared_ptr<const Recording> recording) : recording_(std::move(recording)) {}

  std::string name() const override { return recording_->name; }
  std::span<const Aabb> boxes() const override { return recording_->frame(frame_); }
  std::span<const BodyId> moved() const override { return moved_; }

  bool advance() override {
    if (frame_ + 1 >= recording_->frames()) return false;
    const std::span<const Aabb> before = boxes();
    ++frame_;
    find_moved(before, boxes());
    return true;
  }

 private:
  void find_moved(std::span<const Aabb> before, std::span<const Aabb> now) {
    moved_.clear();
    for (std::size_t body = 0; body < now.size(); ++body) {
      if (now[body] != before[body]) moved_.push_back(static_cast<BodyId>(body));
    }
  }

  std::shared_ptr<const Recording> recording_;
  std::size_t frame_ = 0;
  std::vector<BodyId> moved_;
};

void append_frame(Recording& recording, std::span<const Aabb> boxes) {
  recording.boxes.insert(recording.boxes.end(), boxes.begin(), boxes.end());
}

}  // namespace

Status check_fits_recording(const FrameSource& source) {
  if (source.bodies_come_and_go()) {
    return bad_recording("the bodies of " + source.name() +
                         " come and go, and a recording has the same bodies in all frames; "
                         "a .npz file has room for that");
  }
  if (!source.filters().empty()) {
    return bad_recording("a recording has no filters; a .npz file has room for those of " + source.name());
  }
  return {};
}

Result<Recording> record(FrameSource& source, std::size_t updates, const Aabb& world) {
  if (Status status = check_fits_recording(source); !status.ok()) return status;
  Recording recording;
  recording.name = source.name();
  recording.world = world;
  recording.bodies = source.boxes().size();
  append_frame(recording, source.boxes());
  for (std::size_t update = 0; update < updates && source.advance(); ++update) {
    append_frame(recording, source.boxes());
  }
  if (Status status = source.status(); !status.ok()) return status;
  return recording;
}

std::unique_ptr<FrameSource> make_recording_frames(Recording recording) {
  return make_recording_frames(std::make_shared<const Recording>(std::move(recording)));
}

std::unique_ptr<FrameSource> make_recording_frames(std::shared_ptr<const Recording> recording) {
  return std::make_unique<RecordingFrames>(std::move(recording));
}

Status check_recording(const Recording& recording) {
  const std::string counts =
      std::to_string(recording.boxes.size()) + " boxes for " + std::to_string(recording.bodies) + " bodies";
  if (recording.frames() == 0) return bad_recording("the recording has no frames: " + counts);
  if (recording.boxes.size() % recording.bodies != 0) {
    return bad_recording("the recording's last frame is not whole: " + counts);
  }
  for (std::size_t frame = 0; frame < recording.frames(); ++frame) {
    if (auto fault = find_faulty_box(recording.frame(frame), frame)) return std::move(*fault);
  }
  return {};
}

std::optional<Status> find_faulty_box(std::span<const Aabb> boxes, std::size_t frame) {
  for (std::size_t body = 0; body < boxes.size(); ++body) {
    const auto fault = find_fault(corners_of(boxes[body]));
    if (!fault) continue;
    Status status = bad_recording("frame " + std::to_string(frame) + ", body " + std::to_string(body) +
                                  ": expected " + fault->expected + ", found " + fault->found);
    status.body = static_cast<BodyId>(body);
    return status;
  }
  return std::nullopt;
}

}  // namespace cellsweep
