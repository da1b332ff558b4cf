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
  bool moves = false;
  bool fits = true;
  for (const double d : direction) {
    moves = moves || d != 0;
    fits = fits && std::fabs(d) <= FLT_MAX;
  }
  return moves && fits;
}

inline bool is_good(const Aabb& box) {
  return on_all_axes(valid_lanes(BoxLanes(BoxNumbers::just_written(box))));
}
inline bool is_good(const Region& region) {
  return is_good(region.box) && region.distance >= 0;
}
inline bool is_good(const Path& path) {
  // Most directions are told to be good by their sum, in a third of the steps: it is NaN where one is.
  const auto& [x, y, z] = path.direction;
  const double sum = std::fabs(x) + std::fabs(y) + std::fabs(z);
  const bool is_usual = sum > 0 && sum <= FLT_MAX;
  return is_good(path.box) && (is_usual || is_direction(path.direction)) && path.end >= 0;
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
