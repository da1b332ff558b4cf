#include "bench/queries/question.h"

#include <algorithm>
#include <cmath>

#include "cellsweep/broadphase.h"
#include "world/random.h"

namespace cellsweep::bench {
namespace {

constexpr std::size_t kSamples = 256;

Point center_of(const Aabb& box) {
  Point center{};
  for (std::size_t k = 0; k < 3; ++k) center[k] = 0.5F * (box.min[k] + box.max[k]);
  return center;
}

float between(Random& random, float low, float high) {
  return std::clamp(static_cast<float>(random.between(low, high)), low, high);
}

/// A point in the world's room.
Point point_in(const Aabb& room, Random& random) {
  Point point{};
  for (std::size_t k = 0; k < 3; ++k) point[k] = between(random, room.min[k], room.max[k]);
  return point;
}

/// A point within an edge of a body that is not larger than the world.
Point point_about_a_body(std::span<const Aabb> boxes, const Aabb& room, Random& random) {
  const Aabb& box = boxes[random.below(boxes.size())];
  Point point = center_of(box);
  for (std::size_t k = 0; k < 3; ++k) {
    const float reach = std::clamp(box.max[k] - box.min[k], 1.0F, 10.0F);
    point[k] = std::clamp(point[k] + between(random, -reach, reach), room.min[k], room.max[k]);
  }
  return point;
}

Aabb box_around(const Point& center, float edge) {
  Aabb box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.min[k] = center[k] - 0.5F * edge;
    box.max[k] = center[k] + 0.5F * edge;
  }
  return box;
}

std::array<double, 3> direction_of(double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  return {static_cast<float>(x / length), static_cast<float>(y / length), static_cast<float>(z / length)};
}

std::array<double, 3> any_direction(Random& random) {
  double x = 0;
  double y = 0;
  double z = 0;
  double square = 0;
  do {
    x = random.between(-1, 1);
    y = random.between(-1, 1);
    z = random.between(-1, 1);
    square = x * x + y * y + z * z;
  } while (square > 1 || square < 0.01);
  return direction_of(x, y, z);
}

float diagonal_of(const Aabb& room) {
  double square = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double edge = double{room.max[k]} - room.min[k];
    square += edge * edge;
  }
  return static_cast<float>(std::sqrt(square));
}

Ray make_ray(QuestionKind kind, std::span<const Aabb> boxes, const Aabb& room, Random& random) {
  constexpr float kShort = 4;
  constexpr double kSight = 20;
  switch (kind) {
    case QuestionKind::down: {
      Point above = point_in(room, random);
      above[1] = room.max[1] + 1;
      return {above, {0, -1, 0}, diagonal_of(room)};
    }
    case QuestionKind::segments:
      return {point_about_a_body(boxes, room, random), any_direction(random), kShort};
    case QuestionKind::any:
      return {point_in(room, random), any_direction(random),
              static_cast<float>(kSight * random.positive_unit())};
    default:
      return {point_in(room, random), any_direction(random), diagonal_of(room)};
  }
}

/// Bodies found in the mean by `find(size, center)`, and the size with which that are so many.
template <class Find>
float size_to_find(double wanted, const Find& find, float largest) {
  float low = 0;
  float high = largest;
  for (int step = 0; step < 16; ++step) {
    const float middle = 0.5F * (low + high);
    (find(middle) < wanted ? low : high) = middle;
  }
  return high;
}

}  // namespace

QuestionSizes find_sizes(std::span<const Aabb> boxes, const Aabb& bounds) {
  Broadphase world;
  std::vector<BodyId> ids(boxes.size());
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<BodyId>(i);
  if (!world.insert(ids, boxes).ok() || !world.update().ok()) return {};
  Random random(7, boxes.size());
  std::vector<Point> centers(kSamples);
  for (Point& center : centers) center = point_about_a_body(boxes, bounds, random);
  std::vector<Region> regions(kSamples);
  BatchAnswers<BodyId> found;
  const auto mean_found = [&](const auto& region_of) {
    std::transform(centers.begin(), centers.end(), regions.begin(), region_of);
    return world.queries().find_overlaps(regions, found).ok()
               ? static_cast<double>(found.answers.size()) / kSamples
               : 0;
  };
  const auto in_boxes = [&](float edge) {
    return mean_found([&](const Point& center) { return Region(box_around(center, edge)); });
  };
  const auto in_spheres = [&](float radius) {
    return mean_found([&](const Point& center) { return Region(center, radius); });
  };
  const float largest = std::min(diagonal_of(bounds), 40.0F);
  return {size_to_find(4, in_boxes, largest), size_to_find(100, in_boxes, largest),
          size_to_find(16, in_spheres, largest)};
}

Questions make_questions(QuestionKind kind, std::size_t count, std::span<const Aabb> boxes,
                         const Aabb& bounds, const QuestionSizes& sizes, std::uint64_t seed) {
  Random random(seed, static_cast<std::uint64_t>(kind));
  Questions questions;
  questions.kind = kind;
  questions.radius = sizes.radius;
  for (std::size_t i = 0; i < count; ++i) {
    if (is_ray(kind)) {
      questions.rays.push_back(make_ray(kind, boxes, bounds, random));
      continue;
    }
    const bool anywhere = (kind == QuestionKind::nearest1 || kind == QuestionKind::nearest8) && i % 2 == 1;
    const Point point = anywhere ? point_in(bounds, random) : point_about_a_body(boxes, bounds, random);
    const float edge = kind == QuestionKind::boxes       ? sizes.box
                       : kind == QuestionKind::big_boxes ? sizes.big_box
                                                         : 0;
    questions.boxes.push_back(box_around(point, edge));
  }
  return questions;
}

}  // namespace cellsweep::bench
