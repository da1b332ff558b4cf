#include "engines/stream/bodies/course.h"

#include <algorithm>

#include "base/tuning.h"
#include "engines/stream/bodies/fat_box.h"

namespace cellsweep::stream {
namespace {

float reach_of(int halvings) {
  return tuning::kMostTremble / static_cast<float>(1 << halvings);
}

}  // namespace

Course Course::of_long_ago(std::uint32_t update) {
  Course course;
  course.made_ = static_cast<std::uint8_t>((update + kUpdates / 2) % kUpdates);
  return course;
}

Aabb Course::next_fat_box(const Aabb& fat, const Aabb& before, const Aabb& now, bool left,
                          const NextFatBox& next) {
  const unsigned age = (next.update - made_) % kUpdates;
  if (left && (trembles_ || age <= tuning::kEarly)) {
    judge(age, step_in_lengths(before, now), next.growth);
    if (age > tuning::kEarly && may_have_kept_course(fat, before, now, age)) trembles_ = false;
  }
  made_ = next.update % kUpdates;
  Outlook outlook{.updates = next.updates, .margin = next.margin, .least = next.growth.least};
  if (trembles_) {
    outlook = {.updates = next.growth.updates,
               .may_turn = true,
               .margin = next.margin,
               .reach = reach_of(halvings_)};
  }
  return fat_box_of(before, now, outlook);
}

// Asked when a fat box did not last, or was that of a body which trembles. One that did not last though the
// body was slow was made for another course: the body trembles. From then on its fat boxes reach further to
// either side until they last, and less far where they do: a body that keeps its course has ones that last
// without that.
void Course::judge(unsigned age, float step, const Growth& growth) {
  const bool is_slow = step <= tuning::kMostTremble;
  const int halvings = std::min<int>(halvings_, growth.most_halvings);  // made for another growth
  if (!trembles_) {
    trembles_ = is_slow;
    halvings_ = static_cast<std::uint8_t>(growth.most_halvings);
    while (halvings_ > 0 && reach_of(halvings_) < growth.steps * step) --halvings_;
  } else if (age <= tuning::kEarlyOfTrembling) {
    trembles_ = is_slow;
    halvings_ = static_cast<std::uint8_t>(std::max(halvings - growth.raise, 0));
  } else {
    trembles_ = is_slow && halvings < growth.most_halvings && reach_of(halvings) > step;
    halvings_ = static_cast<std::uint8_t>(halvings + 1);
  }
}

}  // namespace cellsweep::stream
