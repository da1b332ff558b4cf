/// @file
/// The questions that queries are measured by, made from a seed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "cellsweep/query.h"

namespace cellsweep::bench {

enum class QuestionKind {
  boxes,      ///< which bodies overlap a box in which some four are
  big_boxes,  ///< the same with some hundred
  points,     ///< which bodies a point is in
  radius,     ///< which bodies are within a distance of a point: some sixteen
  rays,       ///< the first body on a ray through the world
  down,       ///< the first one below a point above the world
  segments,   ///< the first one on a short way from a body
  any,        ///< whether there is one on a way between two points that are not far from each other
  all,        ///< all bodies on a ray through the world
  nearest1,   ///< the body nearest to a point
  nearest8    ///< the eight nearest
};

struct QuestionKindInfo {
  std::string_view name;
  QuestionKind kind;
  std::string_view title;  ///< for a person
};

inline constexpr std::array kQuestionKinds = {
    QuestionKindInfo{"boxes", QuestionKind::boxes, "boxes, 4 found"},
    QuestionKindInfo{"big_boxes", QuestionKind::big_boxes, "boxes, 100 found"},
    QuestionKindInfo{"points", QuestionKind::points, "points"},
    QuestionKindInfo{"radius", QuestionKind::radius, "radius, 16 found"},
    QuestionKindInfo{"rays", QuestionKind::rays, "first on a ray"},
    QuestionKindInfo{"down", QuestionKind::down, "first below"},
    QuestionKindInfo{"segments", QuestionKind::segments, "first on a short way"},
    QuestionKindInfo{"any", QuestionKind::any, "any between two points"},
    QuestionKindInfo{"all", QuestionKind::all, "all on a ray"},
    QuestionKindInfo{"nearest1", QuestionKind::nearest1, "nearest"},
    QuestionKindInfo{"nearest8", QuestionKind::nearest8, "8 nearest"}};

constexpr bool is_ray(QuestionKind kind) {
  return kind >= QuestionKind::rays && kind <= QuestionKind::all;
}

constexpr std::size_t nearest_of(QuestionKind kind) {
  return kind == QuestionKind::nearest1 ? 1 : 8;
}

/// A list of questions of one kind. Coordinates, directions and lengths are floats, so that everybody is
/// asked for the same.
struct Questions {
  QuestionKind kind = QuestionKind::boxes;
  std::vector<Aabb> boxes;  ///< of boxes; points, and those that the nearest are sought of, are boxes, too
  std::vector<Ray> rays;    ///< of rays: directions are as long as 1, ends are finite
  float radius = 0;         ///< of kind `radius`

  std::size_t size() const { return is_ray(kind) ? rays.size() : boxes.size(); }
};

/// How large boxes and radii have to be in a world for as many bodies to be found as QuestionKind says, in
/// the mean.
struct QuestionSizes {
  float box = 0;
  float big_box = 0;
  float radius = 0;
};

/// Finds them by trying. The boxes are those of the world's bodies, `bounds` is where these are.
QuestionSizes find_sizes(std::span<const Aabb> boxes, const Aabb& bounds);

/// So many questions of a kind to a world. Boxes and points lie about bodies, every other point that the
/// nearest are sought of anywhere in the world; rays begin anywhere.
Questions make_questions(QuestionKind kind, std::size_t count, std::span<const Aabb> boxes,
                         const Aabb& bounds, const QuestionSizes& sizes, std::uint64_t seed);

}  // namespace cellsweep::bench
