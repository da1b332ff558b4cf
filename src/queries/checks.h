/// @file
/// Whether a question can be answered, and the sentences that refuse one.
#pragma once

#include <array>
#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "cellsweep/query.h"
#include "geometry/box_lanes.h"

namespace cellsweep::queries {

/// One that moves, and not beyond floats.
inline bool is_direction(const std::array<double, 3>& direction) {
  using Double2 [[gnu::vector_size(16)]] = double;
  using Long2 [[gnu::vector_size(16)]] = std::int64_t;
  const auto magnitude = [](Double2 values) {
    return reinterpret_cast<Double2>(reinterpret_cast<Long2>(values) & INT64_MAX);
  };
  // Compilers take masks of doubles apart where they are not cast at once.
  const auto fits = [](Double2 values) { return reinterpret_cast<Int4>(values <= double{FLT_MAX}); };
  const auto moves = [](Double2 values) { return reinterpret_cast<Int4>(values > 0.0); };
  const auto& [x, y, z] = direction;
  const Double2 xy = magnitude(Double2{x, y});
  const Double2 zz = magnitude(Double2{z, z});
  return on_all_axes(fits(xy) & fits(zz)) && on_any_axis(moves(xy) | moves(zz));
}

inline bool is_good(const Aabb& box) {
  return on_all_axes(valid_lanes(BoxLanes(box)));
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
