/// @file
/// Whether a question can be answered, and the sentences that refuse one.
#pragma once

#include <array>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>

#include "cellsweep/query.h"
#include "geometry/box_lanes.h"

namespace cellsweep::queries {

/// One that moves, and not beyond floats.
inline bool is_direction(const std::array<double, 3>& direction) {
  const double x = std::fabs(direction[0]);
  const double y = std::fabs(direction[1]);
  const double z = std::fabs(direction[2]);
  const double sum = x + y + z;  // NaN where one is
  // Where the sum fits so does each: one comparison for most directions.
  return sum > 0 && (sum <= FLT_MAX || (x <= FLT_MAX && y <= FLT_MAX && z <= FLT_MAX));
}

inline bool is_good(const Aabb& box) {
  return on_all_axes(valid_lanes(BoxLanes(BoxNumbers::just_written(box))));
}
inline bool is_good(const Region& region) {
  return is_good(region.box) && region.distance >= 0;
}
inline bool is_good(const Path& path) {
  return is_good(path.box) && is_direction(path.direction) && path.end >= 0;
}

/// An ok status for a good question. `place` is that of the question in a batch.
Status check(const Aabb& box, std::optional<std::size_t> place = {});
Status check(const Region& region, std::optional<std::size_t> place = {});
Status check(const Path& path, std::optional<std::size_t> place = {});

/// The first one that is refused, or an ok status.
template <class Question>
Status check_all(std::span<const Question> questions) {
  for (std::size_t i = 0; i < questions.size(); ++i) {
    if (!is_good(questions[i])) return check(questions[i], i);
  }
  return {};
}

/// That of find_nearest().
Status check_most(double most);

/// There must be room for an answer to each question.
Status check_room(std::size_t questions, std::size_t room);

}  // namespace cellsweep::queries
