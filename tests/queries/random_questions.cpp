#include "queries/random_questions.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <memory>

namespace cellsweep::queries {
namespace {

using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

float finite(double value) {
  return static_cast<float>(std::fmax(-double{FLT_MAX}, std::fmin(value, double{FLT_MAX})));
}

std::string text_of(BodyId body) {
  return std::to_string(body);
}
std::string text_of(const Touch& touch) {
  return (testing::Message() << touch.body << " at " << touch.time).GetString();
}
std::string text_of(const Neighbor& neighbor) {
  return (testing::Message() << neighbor.body << " in " << neighbor.distance).GetString();
}

std::string box_text(const Aabb& box) {
  testing::Message text;
  text << std::hexfloat;
  for (std::size_t axis = 0; axis < 3; ++axis) text << " [" << box.min[axis] << ", " << box.max[axis] << "]";
  return text.GetString();
}

template <class Answer>
AssertionResult same(const char* what, std::span<const Answer> given, const std::vector<Answer>& expected) {
  if (std::ranges::equal(given, expected)) return AssertionSuccess();
  AssertionResult failure = AssertionFailure();
  failure << what << ": " << given.size() << " answers and not " << expected.size();
  for (std::size_t i = 0; i < std::max(given.size(), expected.size()); ++i) {
    if (i < given.size() && i < expected.size() && given[i] == expected[i]) continue;
    failure << "; answer " << i << ": ";
    if (i < given.size()) failure << text_of(given[i]);
    failure << " and not ";
    if (i < expected.size()) failure << text_of(expected[i]);
    break;
  }
  return failure;
}

}  // namespace

RandomQuestions::RandomQuestions(const Reference& world, std::uint64_t seed) : random_(seed) {
  for (const auto& [body, box] : world.boxes) boxes_.push_back(box);
  if (boxes_.empty()) boxes_.push_back({{-1, -1, -1}, {1, 1, 1}});
}

const Aabb& RandomQuestions::some_box() {
  return random_.pick(boxes_);
}

// A face, a float beside one, or something in between or beyond.
float RandomQuestions::coordinate(std::size_t axis) {
  const Aabb& box = some_box();
  const float face = random_.one_in(2) ? box.min[axis] : box.max[axis];
  switch (random_.below(8)) {
    case 0:
      return std::nextafter(face, finite(random_.between(-1, 1) * double{FLT_MAX}));
    case 1:
      return finite(face + (double{box.max[axis]} - box.min[axis]) * random_.between(-3, 3));
    case 2:
      return finite(face * double{random_.between(-2, 2)});
    case 3:
      return random_.one_in(8) ? finite(random_.between(-1, 1) * double{FLT_MAX}) : random_.between(-1, 1);
    default:
      return face;
  }
}

Point RandomQuestions::point() {
  return {coordinate(0), coordinate(1), coordinate(2)};
}

Aabb RandomQuestions::box() {
  if (random_.one_in(3)) return some_box();
  const Point one = point();
  const Point other = random_.one_in(2) ? one : point();
  Aabb box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.min[axis] = std::min(one[axis], other[axis]);
    box.max[axis] = std::max(one[axis], other[axis]);
  }
  return box;
}

double RandomQuestions::distance() {
  switch (random_.below(5)) {
    case 0:
      return kInfinity;
    case 1:
      return 0;
    case 2:
      return random_.unit();
    default:
      return box_distance(some_box(), some_box());
  }
}

std::size_t RandomQuestions::count() {
  return random_.one_in(6) ? random_.below(50) : random_.below(6);
}

Region RandomQuestions::region() {
  const Aabb where = box();
  return random_.one_in(2) ? Region(where) : Region(where, distance());
}

// To another point, so that it meets corners exactly or nearly so; along one axis or two; or of an odd
// length.
std::array<double, 3> RandomQuestions::direction(const Point& from) {
  const Point to = point();
  std::array<double, 3> d{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double way = double{to[axis]} - from[axis];
    d[axis] = std::fmax(-double{FLT_MAX}, std::fmin(way, double{FLT_MAX}));
  }
  if (random_.one_in(3)) d[random_.below(3)] = 0;
  if (random_.one_in(3)) d[random_.below(3)] = random_.one_in(2) ? 0.0 : -0.0;
  if (random_.one_in(6)) d[random_.below(3)] *= 1e-20;
  if (random_.one_in(12)) d[random_.below(3)] = 1e-310;
  if (random_.one_in(12)) {
    for (double& component : d) component *= 0x1p-140;
  }
  if (d[0] == 0 && d[1] == 0 && d[2] == 0) d[random_.below(3)] = random_.one_in(2) ? 1 : -1;
  return d;
}

Path RandomQuestions::path() {
  const Aabb where = random_.one_in(2) ? box() : box_at(point());
  Path path(MovingBox{where, direction(where.min), 1});
  switch (random_.below(4)) {
    case 0:
      path.end = kInfinity;
      break;
    case 1:
      path.end = random_.unit();
      break;
    case 2:
      path.end = random_.one_in(2) ? 0 : 1e30;
      break;
    default:
      break;
  }
  return path;
}

QueryFilter RandomQuestions::filter() {
  QueryFilter filter;
  if (random_.one_in(3)) {
    filter.as = BodyFilter{.category = static_cast<std::uint32_t>(random_.below(8)),
                           .mask = static_cast<std::uint32_t>(random_.below(8)),
                           .is_static = random_.one_in(3)};
  }
  if (random_.one_in(3)) {
    filter.predicate = [odd = random_.below(2)](BodyId body) { return body % 2 == odd; };
  }
  return filter;
}

namespace {

AssertionResult overlaps_are_right(const Queries& queries, const Reference& world, RandomQuestions& random) {
  const Region region = random.region();
  const QueryFilter filter = random.filter();
  const std::vector<BodyId> expected = world.overlaps(region, filter);
  std::vector<BodyId> found = {1, 2, 3};
  if (Status status = queries.find_overlaps(region, found, filter); !status.ok())
    return AssertionFailure() << status.message;
  const std::string what = "overlaps of" + box_text(region.box);
  if (AssertionResult result = same<BodyId>(what.c_str(), found, expected); !result)
    return result << ", distance " << region.distance;
  found.clear();
  const std::size_t most = expected.size() / 2 + 1;
  static_cast<void>(queries.visit_overlaps(
      region,
      [&](BodyId body) {
        found.push_back(body);
        return found.size() < most;
      },
      filter));
  std::ranges::sort(found);
  const bool are_some = std::ranges::includes(expected, found) &&
                        std::ranges::adjacent_find(found) == found.end() &&
                        found.size() == std::min(most, expected.size());
  if (!are_some) return AssertionFailure() << "a visit to" << box_text(region.box);
  if (*queries.any_overlap(region, filter) != !expected.empty())
    return AssertionFailure() << "any overlap of" << box_text(region.box);
  std::vector<Neighbor> near;
  static_cast<void>(queries.find_within(region, near, filter));
  return same<Neighbor>("within", near, world.within(region, filter));
}

bool is_first(const std::optional<Touch>& given, const std::vector<Touch>& expected) {
  return expected.empty() ? !given : given && *given == expected.front();
}

// A visit that shortens the path to the first touch so far finds the first one of all.
std::optional<Touch> first_by_visit(const Queries& queries, const Path& path, const QueryFilter& filter) {
  std::optional<Touch> first;
  static_cast<void>(queries.visit_touches(
      path,
      [&](const Touch& touch, double end) {
        const bool is_first =
            !first || std::pair(touch.time, touch.body) < std::pair(first->time, first->body);
        if (is_first) first = touch;
        return std::min(end, touch.time);
      },
      filter));
  return first;
}

AssertionResult touches_are_right(const Queries& queries, const Reference& world, RandomQuestions& random) {
  const Path path = random.path();
  const QueryFilter filter = random.filter();
  const std::vector<Touch> expected = world.touches(path, filter);
  testing::Message text;
  text << "touches of" << box_text(path.box) << " that goes " << std::hexfloat << path.direction[0] << ", "
       << path.direction[1] << ", " << path.direction[2] << " until " << path.end;
  const std::string what = text.GetString();
  std::vector<Touch> found = {{1, 2}};
  if (Status status = queries.find_touches(path, found, filter); !status.ok())
    return AssertionFailure() << status.message;
  if (AssertionResult result = same<Touch>(what.c_str(), found, expected); !result) return result;
  std::vector<Touch> visited;
  static_cast<void>(queries.visit_touches(
      path,
      [&](const Touch& touch, double end) {
        visited.push_back(touch);
        return end;
      },
      filter));
  std::ranges::sort(visited, [](const Touch& one, const Touch& other) {
    return std::pair(one.time, one.body) < std::pair(other.time, other.body);
  });
  if (AssertionResult result = same<Touch>(("a visit to " + what).c_str(), visited, expected); !result)
    return result;
  if (!is_first(*queries.first_touch(path, filter), expected))
    return AssertionFailure() << "the first of the " << what;
  if (!is_first(first_by_visit(queries, path, filter), expected))
    return AssertionFailure() << "the first by a visit of the " << what;
  if (*queries.any_touch(path, filter) == expected.empty())
    return AssertionFailure() << "any of the " << what;
  return AssertionSuccess();
}

AssertionResult nearest_are_right(const Queries& queries, const Reference& world, RandomQuestions& random) {
  const Aabb box = random.box();
  const std::size_t count = random.count();
  const double most = random.distance();
  const QueryFilter filter = random.filter();
  std::vector<Neighbor> found = {{1, 2}};
  if (Status status = queries.find_nearest(box, count, found, most, filter); !status.ok())
    return AssertionFailure() << status.message;
  testing::Message text;
  text << "the " << count << " nearest to" << box_text(box) << " within " << most;
  return same<Neighbor>(text.GetString().c_str(), found, world.nearest(box, count, most, filter));
}

AssertionResult batches_are_right(const Queries& queries, const Reference& world, RandomQuestions& random,
                                  std::size_t batch) {
  const QueryFilter filter = random.filter();
  const std::size_t count = random.count();
  const double most = random.distance();
  std::vector<Region> regions;
  std::vector<Path> paths;
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < batch; ++i) {
    regions.push_back(random.region());
    paths.push_back(random.path());
    boxes.push_back(random.box());
  }
  BatchAnswers<BodyId> overlaps;
  BatchAnswers<Touch> touches;
  BatchAnswers<Neighbor> nearest;
  BatchAnswers<Neighbor> within;
  const auto any_overlaps = std::make_unique<bool[]>(batch);
  const auto any_touches = std::make_unique<bool[]>(batch);
  std::vector<std::optional<Touch>> first(batch);
  for (const Status& status :
       {queries.find_overlaps(regions, overlaps, filter), queries.find_touches(paths, touches, filter),
        queries.find_nearest(boxes, count, nearest, most, filter),
        queries.find_within(regions, within, filter), queries.first_touches(paths, first, filter),
        queries.any_overlaps(regions, {any_overlaps.get(), batch}, filter),
        queries.any_touches(paths, {any_touches.get(), batch}, filter)}) {
    if (!status.ok()) return AssertionFailure() << status.message;
  }
  if (overlaps.size() != batch || touches.size() != batch || nearest.size() != batch ||
      within.size() != batch)
    return AssertionFailure() << "a batch of " << batch << " has fewer or more answers";
  for (std::size_t i = 0; i < batch; ++i) {
    const auto expected = world.touches(paths[i], filter);
    for (const AssertionResult& result :
         {same<BodyId>("overlaps in a batch", overlaps[i], world.overlaps(regions[i], filter)),
          same<Touch>("touches in a batch", touches[i], expected),
          same<Neighbor>("nearest in a batch", nearest[i], world.nearest(boxes[i], count, most, filter)),
          same<Neighbor>("within in a batch", within[i], world.within(regions[i], filter))}) {
      if (!result)
        return AssertionResult(result)
               << ", at" << box_text(regions[i].box) << " within " << regions[i].distance;
    }
    if (!is_first(first[i], expected)) return AssertionFailure() << "a first touch in a batch";
    if (any_touches[i] == expected.empty()) return AssertionFailure() << "any touch in a batch";
    if (any_overlaps[i] != !world.overlaps(regions[i], filter).empty())
      return AssertionFailure() << "any overlap in a batch";
  }
  return AssertionSuccess();
}

AssertionResult pairs_of_some_are_right(const Queries& queries, const Reference& world, std::uint64_t seed) {
  contract::Random random(seed);
  std::vector<BodyId> bodies;
  for (const auto& [body, box] : world.boxes) {
    if (random.one_in(1 + world.boxes.size() / 10)) bodies.push_back(body);
  }
  random.shuffle(bodies);
  if (!bodies.empty() && random.one_in(2)) bodies.push_back(bodies.front());
  std::vector<Pair> found = {{1, 2}};
  if (Status status = queries.find_pairs_of(bodies, found); !status.ok())
    return AssertionFailure() << status.message;
  const std::vector<Pair> expected = world.pairs_of(bodies);
  if (found != expected)
    return AssertionFailure() << found.size() << " pairs of some bodies and not " << expected.size();
  return AssertionSuccess();
}

}  // namespace

AssertionResult answers_are_right(const Queries& queries, const Reference& world, std::uint64_t seed,
                                  std::size_t batch) {
  RandomQuestions random(world, seed);
  for (const auto ask : {overlaps_are_right, touches_are_right, nearest_are_right}) {
    if (AssertionResult result = ask(queries, world, random); !result) return result << ", seed " << seed;
  }
  if (AssertionResult result = batches_are_right(queries, world, random, batch); !result)
    return result << ", seed " << seed;
  return pairs_of_some_are_right(queries, world, seed) << ", seed " << seed;
}

}  // namespace cellsweep::queries
