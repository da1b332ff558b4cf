#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/text.h"
#include "bindings/boxes_of_world.h"
#include "bindings/python/arrays.h"
#include "bindings/python/errors.h"
#include "bindings/python/parts.h"
#include "cellsweep/engines.h"
#include "cellsweep/stream_view.h"

namespace cellsweep::python {
namespace {

using namespace py::literals;

/// A setting's value as the table of engines reads it.
std::string setting_text(const py::handle& value) {
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
  return py::str(value);
}

std::unique_ptr<LockedWorld> make_world(const std::string& engine, const py::kwargs& settings) {
  SettingValues values;
  for (const auto& [name, value] : settings) values.emplace_back(py::str(name), setting_text(value));
  auto made = make_broadphase(engine, values);
  raise_unless_ok(made.status());
  return std::make_unique<LockedWorld>(std::move(*made));
}

void insert(LockedWorld& world, const py::object& ids, const py::object& boxes, const py::object& category,
            const py::object& mask, const py::object& is_static) {
  const Ids read_ids(ids);
  std::vector<Aabb> own;
  const Boxes read = read_boxes(boxes);
  const std::span<const Aabb> of_world = bindings::boxes_of_world(read.view, own);
  const auto filters = read_filters(category, mask, is_static, read_ids.view().size());
  const Status status = world.change([&](Broadphase& broadphase) {
    return filters && !filters->empty() ? broadphase.insert(read_ids.view(), of_world, *filters)
                                        : broadphase.insert(read_ids.view(), of_world);
  });
  raise_unless_ok(status, read_ids.view());
}

py::array_t<BodyId> add(LockedWorld& world, const py::object& boxes, const py::object& category,
                        const py::object& mask, const py::object& is_static) {
  std::vector<Aabb> own;
  const Boxes read = read_boxes(boxes);
  const std::span<const Aabb> of_world = bindings::boxes_of_world(read.view, own);
  const auto filters = read_filters(category, mask, is_static, of_world.size());
  std::vector<BodyId> ids(of_world.size());
  raise_unless_ok(world.change([&](Broadphase& broadphase) {
    Status status = broadphase.add(of_world, ids);
    if (!status.ok() || !filters || filters->empty()) return status;
    try {
      return broadphase.set_filters(ids, *filters);
    } catch (...) {
      static_cast<void>(broadphase.remove(ids));
      throw;
    }
  }));
  return hand_over_list(std::move(ids));
}

void move(LockedWorld& world, const py::object& ids, const py::object& boxes) {
  const Ids read_ids(ids);
  std::vector<Aabb> own;
  const Boxes read = read_boxes(boxes);
  const std::span<const Aabb> of_world = bindings::boxes_of_world(read.view, own);
  const Status status =
      world.change([&](Broadphase& broadphase) { return broadphase.move(read_ids.view(), of_world); });
  raise_unless_ok(status, read_ids.view());
}

void remove(LockedWorld& world, const py::object& ids) {
  const Ids read(ids);
  const Status status = world.change([&](Broadphase& broadphase) { return broadphase.remove(read.view()); });
  raise_unless_ok(status, read.view());
}

/// Settings that are not named stay what they are.
void set_filters(LockedWorld& world, const py::object& ids, const py::object& category,
                 const py::object& mask, const py::object& is_static) {
  const Ids read(ids);
  const auto wanted = read_filters(category, mask, is_static, read.view().size());
  if (!wanted) return;
  const bool sets_category = !category.is_none();
  const bool sets_mask = !mask.is_none();
  const bool sets_static = !is_static.is_none();
  std::vector<BodyFilter> filters = *wanted;
  const Status status = world.change([&](Broadphase& broadphase) {
    for (std::size_t i = 0; i < filters.size(); ++i) {
      // Of an unknown id set_filters() says so.
      const BodyFilter now = broadphase.filter(read.view()[i]).value_or(BodyFilter{});
      if (!sets_category) filters[i].category = now.category;
      if (!sets_mask) filters[i].mask = now.mask;
      if (!sets_static) filters[i].is_static = now.is_static;
    }
    return broadphase.set_filters(read.view(), filters);
  });
  raise_unless_ok(status, read.view());
}

py::tuple filters_of(const LockedWorld& world, const py::object& ids) {
  const Ids read(ids);
  std::vector<std::uint32_t> categories;
  std::vector<std::uint32_t> masks;
  std::vector<std::uint8_t> are_static;
  const Status status = world.look([&](const Broadphase& broadphase) {
    for (const BodyId id : read.view()) {
      const std::optional<BodyFilter> filter = broadphase.filter(id);
      if (!filter)
        return Status::bad_bodies(StatusCode::unknown_body, text("Body ", id, " is not held."), {&id, 1});
      categories.push_back(filter->category);
      masks.push_back(filter->mask);
      are_static.push_back(filter->is_static ? 1 : 0);
    }
    return Status{};
  });
  raise_unless_ok(status, read.view());
  return py::make_tuple(hand_over_list(std::move(categories)), hand_over_list(std::move(masks)),
                        hand_over_list(std::move(are_static)).attr("view")("bool"));
}

/// Copies: the engine's lists are gone with the next update.
py::object update(LockedWorld& world) {
  std::vector<Pair> began;
  std::vector<Pair> ended;
  const Status status = world.change([&](Broadphase& broadphase) {
    const Result<PairChanges> changes = broadphase.update();
    if (!changes) return changes.status();
    began.assign(changes->began.begin(), changes->began.end());
    ended.assign(changes->ended.begin(), changes->ended.end());
    return Status{};
  });
  raise_unless_ok(status);
  return py::module_::import("cellsweep")
      .attr("Changes")(hand_over_pairs(std::move(began)), hand_over_pairs(std::move(ended)));
}

py::array_t<std::uint32_t> pairs(const LockedWorld& world) {
  return hand_over_pairs(world.look([](const Broadphase& broadphase) {
    const std::span<const Pair> all = broadphase.pairs();
    return std::vector(all.begin(), all.end());
  }));
}

py::array_t<float> boxes_of(const LockedWorld& world, const py::object& ids) {
  const Ids read(ids);
  std::vector<Aabb> boxes(read.view().size());
  const Status status =
      world.look([&](const Broadphase& broadphase) { return broadphase.boxes(read.view(), boxes); });
  raise_unless_ok(status, read.view());
  return hand_over_boxes(std::move(boxes));
}

py::dict statistics(const LockedWorld& world) {
  const Statistics of = world.look([](const Broadphase& broadphase) { return broadphase.statistics(); });
  py::dict phases;
  py::dict counters;
  for (const Phase& phase : of.phases) phases[py::str(std::string(phase.name))] = phase.milliseconds;
  for (const Counter& counter : of.counters) counters[py::str(std::string(counter.name))] = counter.value;
  return py::dict("updates"_a = of.updates, "bytes"_a = of.bytes, "boxes_placed"_a = of.work.boxes_placed,
                  "boxes_compared"_a = of.work.boxes_compared, "milliseconds"_a = phases,
                  "counters"_a = counters);
}

/// (fat boxes, cells), or None.
py::object view_of_stream(const LockedWorld& world) {
  auto view = world.look([](const Broadphase& broadphase) { return stream_view(broadphase); });
  if (!view) return py::none();
  return py::make_tuple(hand_over_boxes(std::move(view->fat_boxes)), hand_over_boxes(std::move(view->cells)));
}

std::string describe(const LockedWorld& world) {
  return world.look([](const Broadphase& broadphase) {
    return text("<cellsweep.World: ", broadphase.size(), " bodies, engine '", broadphase.name(), "'>");
  });
}

py::list engines() {
  py::list rows;
  for (const EngineInfo& info : engine_table()) {
    rows.append(py::make_tuple(std::string(info.name), std::string(info.summary)));
  }
  return rows;
}

void add_changes(WorldClass& world) {
  world.def("insert", insert, "ids"_a, "boxes"_a, py::kw_only(), "category"_a = py::none(),
            "mask"_a = py::none(), "static"_a = py::none(),
            R"(Adds bodies with ids of the caller's: (n,) whole numbers 0 to 2**32 - 1, each once.

boxes: (n, 2, d) and so on, as find_pairs() takes them. The world's boxes are float32 in
    three dimensions: float32 of shape (n, 2, 3) or (n, 6) in C order is not copied on the
    way, float64 is rounded outward, the third dimension of d = 2 is 0 to 0.
category, mask, static: a number for all or one for each. Two bodies form a pair only
    where each one's category has a bit in common with the other's mask, and not both are
    static. Without: 1, 0xffffffff, False.

Takes effect in the next update(). Raises InvalidBoxError, DuplicateBodyError,
CapacityError, InputError, which name ids and rows; nothing has changed then.)");
  world.def("add", add, "boxes"_a, py::kw_only(), "category"_a = py::none(), "mask"_a = py::none(),
            "static"_a = py::none(),
            R"(Adds bodies whose ids the world hands out: returns them, (n,) uint32, small ones.)");
  world.def("move", move, "ids"_a, "boxes"_a,
            R"(Gives bodies new boxes, in the next update(). Of several for one body the last counts.

Raises UnknownBodyError, InvalidBoxError, InputError, which name ids and rows.)");
  world.def("remove", remove, "ids"_a, R"(Removes bodies; their pairs end in the next update().

Raises UnknownBodyError, DuplicateBodyError.)");
  world.def("set_filters", set_filters, "ids"_a, py::kw_only(), "category"_a = py::none(),
            "mask"_a = py::none(), "static"_a = py::none(),
            R"(Gives bodies other filters; what is not named stays as it is.)");
  world.def("update", update, R"(Brings the pairs up to date and returns what changed since the last update.

Returns Changes(began, ended): arrays (m, 2) of ids, uint32, ascending, the smaller id
first. Raises CapacityError where there are more pairs than the engine's `max_pairs`.)");
}

void add_state(WorldClass& world) {
  world.def_property_readonly("pairs", pairs,
                              R"(All pairs as of the last update(): (m, 2) ids, uint32, ascending. A copy.)");
  world.def("boxes", boxes_of, "ids"_a, R"(Boxes as of the last update(): (n, 2, 3) float32.

Raises UnknownBodyError for ids that it did not see.)");
  world.def("filters", filters_of, "ids"_a, R"((categories, masks, static) of bodies: three arrays (n,).)");
  world.def("__len__",
            [](const LockedWorld& of) { return of.look([](const Broadphase& b) { return b.size(); }); });
  world.def("__contains__", [](const LockedWorld& of, BodyId id) {
    return of.look([&](const Broadphase& b) { return b.contains(id); });
  });
  world.def("__repr__", describe);
  world.def_property_readonly(
      "engine",
      [](const LockedWorld& of) {
        return of.look([](const Broadphase& b) { return std::string(b.name()); });
      },
      R"(The name of its engine.)");
  world.def_property_readonly(
      "capacity",
      [](const LockedWorld& of) { return of.look([](const Broadphase& b) { return b.capacity().bodies; }); },
      R"(The number of bodies that there may be.)");
  world.def(
      "stream_view", view_of_stream,
      R"(What engine `stream` has made of the bodies, to draw: (fat_boxes, cells), arrays (n, 2, 3) in any order;
None for other engines. Fat boxes are those that bodies may move in before their pairs are
searched anew, cells those that bodies are in, within each other where one was crowded.)");
  world.def_property_readonly(
      "statistics", statistics,
      R"(A dict of what was measured and counted; milliseconds are of the last update().)");
}

}  // namespace

WorldClass add_world(py::module_& module) {
  module.def("engines", engines, R"(The engines that a World can have: a list of (name, summary).)");
  WorldClass world(module, "World", R"(Bodies with boxes, and the exact set of their overlapping pairs.

World(engine="stream", **settings); settings are those of the engine, such as
threads=2 or max_pairs=1_000_000. Insertions, moves, filters and removals take effect
together in update(). Questions are answered as of the last update().

Threads: a world may be shared. Calls that change it wait for each other and for those
that only look, which run at the same time. Other Python threads run meanwhile; arrays
that a call was given must not change until it returns.)");
  world.def(py::init(&make_world), "engine"_a = "stream");
  add_changes(world);
  add_state(world);
  return world;
}

}  // namespace cellsweep::python
