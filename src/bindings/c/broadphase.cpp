#include "cellsweep/c/broadphase.h"

#include <optional>

#include "base/text.h"
#include "bindings/c/call.h"
#include "bindings/c/objects.h"
#include "bindings/c/views.h"

using namespace cellsweep;
using namespace cellsweep::c;

namespace {

/// Reads all that a call was given, one after the other.
template <class... Views>
Status read_all(Bodies& bodies, const Views&... views) {
  Status status;
  ((status.ok() ? void(status = bodies.read(views)) : void()), ...);
  return status;
}

}  // namespace

const char* cellsweep_engine_name(const cellsweep_broadphase* broadphase) {
  return broadphase == nullptr ? nullptr : broadphase->engine.c_str();
}

uint64_t cellsweep_capacity(const cellsweep_broadphase* broadphase) {
  return broadphase == nullptr ? 0 : broadphase->capacity;
}

cellsweep_status cellsweep_insert(cellsweep_broadphase* broadphase, cellsweep_ids ids, cellsweep_boxes boxes,
                                  cellsweep_filters filters, cellsweep_failure* failure) {
  return call(failure, {{broadphase, "broadphase"}}, [&] {
    Bodies bodies;
    Status status = read_all(bodies, ids, boxes, filters);
    if (!status.ok()) return status;
    if (filters.count == 0) return broadphase->handle.insert(bodies.ids.view(), bodies.boxes);
    return broadphase->handle.insert(bodies.ids.view(), bodies.boxes, bodies.filters.view());
  });
}

cellsweep_status cellsweep_add(cellsweep_broadphase* broadphase, cellsweep_boxes boxes, uint32_t* ids,
                               cellsweep_failure* failure) {
  return call(failure,
              {{broadphase, "broadphase"}, {boxes.count == 0 ? &boxes : static_cast<void*>(ids), "ids"}},
              [&] {
                Bodies bodies;
                if (Status status = bodies.read(boxes); !status.ok()) return status;
                return broadphase->handle.add(bodies.boxes, {ids, boxes.count});
              });
}

cellsweep_status cellsweep_move(cellsweep_broadphase* broadphase, cellsweep_ids ids, cellsweep_boxes boxes,
                                cellsweep_failure* failure) {
  return call(failure, {{broadphase, "broadphase"}}, [&] {
    Bodies bodies;
    Status status = read_all(bodies, ids, boxes);
    return status.ok() ? broadphase->handle.move(bodies.ids.view(), bodies.boxes) : status;
  });
}

cellsweep_status cellsweep_set_filters(cellsweep_broadphase* broadphase, cellsweep_ids ids,
                                       cellsweep_filters filters, cellsweep_failure* failure) {
  return call(failure, {{broadphase, "broadphase"}}, [&] {
    Bodies bodies;
    Status status = read_all(bodies, ids, filters);
    return status.ok() ? broadphase->handle.set_filters(bodies.ids.view(), bodies.filters.view()) : status;
  });
}

cellsweep_status cellsweep_remove(cellsweep_broadphase* broadphase, cellsweep_ids ids,
                                  cellsweep_failure* failure) {
  return call(failure, {{broadphase, "broadphase"}}, [&] {
    Bodies bodies;
    Status status = bodies.read(ids);
    return status.ok() ? broadphase->handle.remove(bodies.ids.view()) : status;
  });
}

cellsweep_status cellsweep_update(cellsweep_broadphase* broadphase, cellsweep_changes* changes,
                                  cellsweep_failure* failure) {
  return call(failure, {{broadphase, "broadphase"}}, [&] {
    const Result<PairChanges> changed = broadphase->handle.update();
    if (changed && changes != nullptr) *changes = changes_of(*changed);
    return changed.status();
  });
}

cellsweep_status cellsweep_pairs(const cellsweep_broadphase* broadphase, const cellsweep_pair** pairs,
                                 size_t* count, cellsweep_failure* failure) {
  return call(failure, {{broadphase, "broadphase"}, {pairs, "pairs"}, {count, "count"}}, [&] {
    const std::span<const Pair> all = broadphase->handle.pairs();
    *pairs = seen_as<const cellsweep_pair>(all.data());
    *count = all.size();
    return Status{};
  });
}

cellsweep_status cellsweep_read_boxes(const cellsweep_broadphase* broadphase, cellsweep_ids ids,
                                      cellsweep_aabb* boxes, cellsweep_failure* failure) {
  return call(failure,
              {{broadphase, "broadphase"}, {ids.count == 0 ? &ids : static_cast<void*>(boxes), "boxes"}},
              [&] {
                Bodies bodies;
                if (Status status = bodies.read(ids); !status.ok()) return status;
                return broadphase->handle.boxes(bodies.ids.view(), seen_as<Aabb>(boxes, ids.count));
              });
}

size_t cellsweep_size(const cellsweep_broadphase* broadphase) {
  return broadphase == nullptr ? 0 : broadphase->handle.size();
}

bool cellsweep_contains(const cellsweep_broadphase* broadphase, uint32_t id) {
  return broadphase != nullptr && broadphase->handle.contains(id);
}

cellsweep_status cellsweep_filter_of(const cellsweep_broadphase* broadphase, uint32_t id,
                                     cellsweep_filter* filter, cellsweep_failure* failure) {
  return call(failure, {{broadphase, "broadphase"}, {filter, "filter"}}, [&] {
    const std::optional<BodyFilter> held = broadphase->handle.filter(id);
    if (!held)
      return Status::bad_bodies(StatusCode::unknown_body, text("Body ", id, " is not held."), {&id, 1});
    *filter = {held->category, held->mask, held->is_static};
    return Status{};
  });
}

cellsweep_statistics cellsweep_statistics_of(const cellsweep_broadphase* broadphase) {
  if (broadphase == nullptr) return {};
  const Statistics& of = broadphase->handle.statistics();
  return {of.updates,       of.bytes,          of.work.boxes_placed, of.work.boxes_compared,
          of.phases.size(), of.counters.size()};
}

cellsweep_phase cellsweep_phase_at(const cellsweep_broadphase* broadphase, size_t place) {
  if (place >= cellsweep_statistics_of(broadphase).phase_count) return {};
  const Phase& phase = broadphase->handle.statistics().phases[place];
  return {phase.name.data(), phase.milliseconds};
}

cellsweep_counter cellsweep_counter_at(const cellsweep_broadphase* broadphase, size_t place) {
  if (place >= cellsweep_statistics_of(broadphase).counter_count) return {};
  const Counter& counter = broadphase->handle.statistics().counters[place];
  return {counter.name.data(), counter.value};
}
