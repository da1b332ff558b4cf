#include <pybind11/pybind11.h>

#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "bindings/boxes_of_world.h"
#include "bindings/python/arrays.h"
#include "bindings/python/errors.h"
#include "bindings/python/parts.h"
#include "cellsweep/query.h"

namespace cellsweep::python {
namespace {

using namespace py::literals;
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

QueryFilter filter_of(const py::object& category, const py::object& mask, const py::object& is_static) {
  QueryFilter filter;
  filter.as = read_filter(category, mask, is_static);
  return filter;
}

/// A number for each of `count` questions, from one for all or one for each.
std::vector<double> read_numbers(const py::object& from, std::size_t count, const char* name) {
  const auto array = Numbers::ensure(from);
  if (!array) {
    PyErr_Clear();
    throw py::type_error(text("`", name, "` is a number, or an array of them."));
  }
  if (array.ndim() == 0) return std::vector<double>(count, *array.data());
  if (array.ndim() == 1 && static_cast<std::size_t>(array.size()) == count) {
    return {array.data(), array.data() + count};
  }
  throw py::value_error(text("`", name, "` is one number, or one for each of ", count, " questions."));
}

/// Questions' boxes as floats in three dimensions.
struct AskedBoxes {
  explicit AskedBoxes(const py::object& from)
      : read(read_boxes(from)), boxes(bindings::boxes_of_world(read.view, own)) {}

  std::vector<Aabb> own;
  Boxes read;
  std::span<const Aabb> boxes;
};

std::vector<Region> read_regions(const py::object& boxes, const py::object& distance) {
  const AskedBoxes asked(boxes);
  const std::vector<double> distances = read_numbers(distance, asked.boxes.size(), "distance");
  std::vector<Region> regions;
  regions.reserve(asked.boxes.size());
  for (std::size_t i = 0; i < asked.boxes.size(); ++i) regions.emplace_back(asked.boxes[i], distances[i]);
  return regions;
}

/// Directions of shape (n, d), or one for all.
std::vector<Path> read_paths(const py::object& from, const py::object& direction, const py::object& end) {
  const AskedBoxes asked(from);
  const std::size_t count = asked.boxes.size();
  const auto directions = Numbers::ensure(direction);
  const py::ssize_t axes = directions && directions.ndim() > 0 ? directions.shape(directions.ndim() - 1) : 0;
  const bool is_one = directions && directions.ndim() == 1;
  const bool are_many =
      directions && directions.ndim() == 2 && static_cast<std::size_t>(directions.shape(0)) == count;
  if ((axes != 2 && axes != 3) || (!is_one && !are_many)) {
    PyErr_Clear();
    throw py::value_error(
        text("`direction` has the shape (3,), (2,), or (n, 3) or (n, 2) with one for each of ", count,
             " questions."));
  }
  const std::vector<double> ends = read_numbers(end, count, "end");
  std::vector<Path> paths(count);
  for (std::size_t i = 0; i < count; ++i) {
    paths[i].box = asked.boxes[i];
    const double* to = directions.data() + (is_one ? 0 : i * static_cast<std::size_t>(axes));
    for (py::ssize_t axis = 0; axis < axes; ++axis)
      paths[i].direction[static_cast<std::size_t>(axis)] = to[axis];
    paths[i].end = ends[i];
  }
  return paths;
}

py::array_t<std::int64_t> hand_over_first(const std::vector<std::size_t>& first) {
  return hand_over_list(first.empty() ? std::vector<std::int64_t>{0}
                                      : std::vector<std::int64_t>(first.begin(), first.end()));
}

py::object make_answers(const py::object& first, const py::object& bodies, const py::object& values) {
  return py::module_::import("cellsweep").attr("Answers")(first, bodies, values);
}

py::object hand_over_answers(BatchAnswers<BodyId> found) {
  return make_answers(hand_over_first(found.first), hand_over_list(std::move(found.answers)), py::none());
}

template <class Answer>
py::object hand_over_answers(const BatchAnswers<Answer>& found, double Answer::*value) {
  std::vector<BodyId> bodies;
  std::vector<double> values;
  bodies.reserve(found.answers.size());
  values.reserve(found.answers.size());
  for (const Answer& answer : found.answers) {
    bodies.push_back(answer.body);
    values.push_back(answer.*value);
  }
  return make_answers(hand_over_first(found.first), hand_over_list(std::move(bodies)),
                      hand_over_list(std::move(values)));
}

/// Truths for `count` questions, which `ask(span)` writes.
template <class Ask>
py::object find_any(std::size_t count, const Ask& ask) {
  const auto any = std::make_unique<bool[]>(count);  // NOLINT(*-avoid-c-arrays): vector<bool> has no bools
  raise_unless_ok(ask(std::span<bool>(any.get(), count)));
  return hand_over_list(std::vector<std::uint8_t>(any.get(), any.get() + count)).attr("view")("bool");
}

py::object find_overlaps(const LockedWorld& world, const py::object& boxes, const py::object& distance,
                         const py::object& category, const py::object& mask, const py::object& is_static) {
  const std::vector<Region> regions = read_regions(boxes, distance);
  const QueryFilter filter = filter_of(category, mask, is_static);
  BatchAnswers<BodyId> found;
  raise_unless_ok(
      world.ask([&](const Queries& queries) { return queries.find_overlaps(regions, found, filter); }));
  return hand_over_answers(std::move(found));
}

py::object any_overlaps(const LockedWorld& world, const py::object& boxes, const py::object& distance,
                        const py::object& category, const py::object& mask, const py::object& is_static) {
  const std::vector<Region> regions = read_regions(boxes, distance);
  const QueryFilter filter = filter_of(category, mask, is_static);
  return find_any(regions.size(), [&](std::span<bool> any) {
    return world.ask([&](const Queries& queries) { return queries.any_overlaps(regions, any, filter); });
  });
}

py::object find_touches(const LockedWorld& world, const py::object& boxes, const py::object& direction,
                        const py::object& end, const py::object& category, const py::object& mask,
                        const py::object& is_static) {
  const std::vector<Path> paths = read_paths(boxes, direction, end);
  const QueryFilter filter = filter_of(category, mask, is_static);
  BatchAnswers<Touch> found;
  raise_unless_ok(
      world.ask([&](const Queries& queries) { return queries.find_touches(paths, found, filter); }));
  return hand_over_answers(found, &Touch::time);
}

py::object first_touches(const LockedWorld& world, const py::object& boxes, const py::object& direction,
                         const py::object& end, const py::object& category, const py::object& mask,
                         const py::object& is_static) {
  const std::vector<Path> paths = read_paths(boxes, direction, end);
  const QueryFilter filter = filter_of(category, mask, is_static);
  std::vector<std::optional<Touch>> found(paths.size());
  raise_unless_ok(
      world.ask([&](const Queries& queries) { return queries.first_touches(paths, found, filter); }));
  std::vector<std::int64_t> bodies;
  std::vector<double> times;
  for (const std::optional<Touch>& touch : found) {
    bodies.push_back(touch ? std::int64_t{touch->body} : -1);
    times.push_back(touch ? touch->time : std::numeric_limits<double>::quiet_NaN());
  }
  return py::make_tuple(hand_over_list(std::move(bodies)), hand_over_list(std::move(times)));
}

py::object any_touches(const LockedWorld& world, const py::object& boxes, const py::object& direction,
                       const py::object& end, const py::object& category, const py::object& mask,
                       const py::object& is_static) {
  const std::vector<Path> paths = read_paths(boxes, direction, end);
  const QueryFilter filter = filter_of(category, mask, is_static);
  return find_any(paths.size(), [&](std::span<bool> any) {
    return world.ask([&](const Queries& queries) { return queries.any_touches(paths, any, filter); });
  });
}

py::object find_nearest(const LockedWorld& world, const py::object& boxes, std::size_t count, double most,
                        const py::object& category, const py::object& mask, const py::object& is_static) {
  const AskedBoxes asked(boxes);
  const QueryFilter filter = filter_of(category, mask, is_static);
  BatchAnswers<Neighbor> found;
  raise_unless_ok(world.ask(
      [&](const Queries& queries) { return queries.find_nearest(asked.boxes, count, found, most, filter); }));
  return hand_over_answers(found, &Neighbor::distance);
}

py::object find_within(const LockedWorld& world, const py::object& boxes, const py::object& distance,
                       const py::object& category, const py::object& mask, const py::object& is_static) {
  const std::vector<Region> regions = read_regions(boxes, distance);
  const QueryFilter filter = filter_of(category, mask, is_static);
  BatchAnswers<Neighbor> found;
  raise_unless_ok(
      world.ask([&](const Queries& queries) { return queries.find_within(regions, found, filter); }));
  return hand_over_answers(found, &Neighbor::distance);
}

py::array_t<std::uint32_t> pairs_of(const LockedWorld& world, const py::object& ids) {
  const Ids read(ids);
  std::vector<Pair> found;
  raise_unless_ok(
      world.ask([&](const Queries& queries) { return queries.find_pairs_of(read.view(), found); }),
      read.view());
  return hand_over_pairs(std::move(found));
}

}  // namespace

void add_questions(py::module_&, WorldClass& world) {
  const auto none = py::none();
  constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  world.def("find_overlaps", find_overlaps, "boxes"_a, "distance"_a = 0.0, py::kw_only(), "category"_a = none,
            "mask"_a = none, "static"_a = none,
            R"(Bodies that overlap each of n boxes or points: Answers, ids ascending.

boxes: (n, 2, 3), (n, 6) and so on, or points (n, 3).
distance: bodies no further than this; one number or (n,). Points with one are spheres.
category, mask, static: only bodies that a body with this filter may meet.
Raises InvalidBoxError, InputError, which name the first question at fault.)");
  world.def("any_overlaps", any_overlaps, "boxes"_a, "distance"_a = 0.0, py::kw_only(), "category"_a = none,
            "mask"_a = none, "static"_a = none,
            R"(Whether a body overlaps each of n boxes or points: (n,) bool.)");
  world.def("find_touches", find_touches, "boxes"_a, "direction"_a, "end"_a = kUnbounded, py::kw_only(),
            "category"_a = none, "mask"_a = none, "static"_a = none,
            R"(Bodies on each of n ways: Answers with times, ascending by (time, id).

boxes: where each begins; points for rays, boxes for boxes that move.
direction: (3,) for all or (n, 3), not zero; times are in its lengths.
end: the time at which each ends; one number or (n,).)");
  world.def(
      "first_touches", first_touches, "boxes"_a, "direction"_a, "end"_a = kUnbounded, py::kw_only(),
      "category"_a = none, "mask"_a = none, "static"_a = none,
      R"(The first body on each of n ways: (ids, times), (n,) int64 with -1 for none and (n,) float64 with NaN.)");
  world.def("any_touches", any_touches, "boxes"_a, "direction"_a, "end"_a = kUnbounded, py::kw_only(),
            "category"_a = none, "mask"_a = none, "static"_a = none,
            R"(Whether a body is on each of n ways: (n,) bool.)");
  world.def(
      "find_nearest", find_nearest, "boxes"_a, "count"_a = 1, "most"_a = kUnbounded, py::kw_only(),
      "category"_a = none, "mask"_a = none, "static"_a = none,
      R"(The `count` bodies nearest to each of n boxes or points, none further than `most`: Answers with distances,
ascending by (distance, id).)");
  world.def("find_within", find_within, "boxes"_a, "distance"_a, py::kw_only(), "category"_a = none,
            "mask"_a = none, "static"_a = none,
            R"(Bodies within a distance of each of n boxes or points: Answers with distances, ascending.)");
  world.def("pairs_of", pairs_of, "ids"_a,
            R"(The pairs as of the last update() in which one of these bodies is: (m, 2) ids, ascending.)");
  world.def(
      "prepare_queries",
      [](const LockedWorld& of) {
        of.ask([](const Queries& queries) {
          queries.prepare();
          return true;
        });
      },
      R"(Makes the tree that ways and nearest bodies are found through, or brings it up to date, before many questions.)");
}

}  // namespace cellsweep::python
