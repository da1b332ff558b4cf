#include "engines/stream/bodies/fat_box_trial.h"

#include "geometry/box_lanes.h"

namespace cellsweep::stream {

void FatBoxTrial::begin(const BodyChanges& changes) {
  const std::size_t step = changes.moved.size() / tuning::kTried + 1;
  count_ = 0;
  for (std::size_t i = 0; i < changes.moved.size(); i += step) {
    slots_[count_] = changes.moved[i];
    boxes_[count_] = changes.boxes[changes.moved[i]];
    ++count_;
  }
  updates_ = 0;
  escaped_ = 0;
  fat_boxes_.drop_slack();
}

bool FatBoxTrial::go_on(Crew& crew, const BodyChanges& changes) {
  const std::array<Aabb, tuning::kTried> before = boxes_;
  std::array<Slot, tuning::kTried> moved;  // NOLINT(*-member-init): as far as it is read
  std::size_t moves = 0;
  for (std::size_t i = 0; i < count_; ++i) {
    const Aabb& now = changes.boxes[slots_[i]];
    boxes_[i] = now;
    if (!(now.min[0] <= now.max[0])) return false;
    moved[moves] = static_cast<Slot>(i);
    moves += same_bits(BoxLanes(now), BoxLanes(before[i])) ? 0 : 1;
  }
  ++updates_;
  if (moves == 0) return true;
  BodyChanges of_these{};
  of_these.boxes = std::span(boxes_).first(count_);
  of_these.before = {std::span(before).first(count_)};
  of_these.moved = std::span(moved).first(moves);
  of_these.bodies = count_;
  fat_boxes_.take(crew, of_these, {.most_listed = count_});
  if (updates_ > kSettling) escaped_ += fat_boxes_.changes().size();
  return true;
}

double FatBoxTrial::share_escaped() const {
  if (updates_ <= kSettling) return 1;
  return static_cast<double>(escaped_) / static_cast<double>(count_ * (updates_ - kSettling));
}

}  // namespace cellsweep::stream
