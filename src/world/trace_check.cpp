#include "world/trace_check.h"

#include <algorithm>
#include <array>
#include <utility>

namespace cellsweep {
namespace {

using Fault = std::optional<TraceFault>;

/// Ids are places of arrays; a file may not ask for many times more of them than it has bodies.
constexpr std::size_t kFewIds = std::size_t{1} << 20;
constexpr std::size_t kIdsOfBody = 16;

/// One of the three lists, and where each frame's part of it ends.
struct List {
  std::string_view name;
  std::string_view ends_name;
  const std::vector<BodyId>& bodies;
  const std::vector<std::size_t>& ends;
};

Fault find_fault_of_ends(const List& list, std::size_t frames) {
  const auto& ends = list.ends;
  if (ends.empty()) return TraceFault{list.ends_name, 0, 0, "at least one frame", "none"};
  if (ends.size() != frames) {
    return TraceFault{list.ends_name, std::min(ends.size(), frames), 0,
                      std::to_string(frames) + " frames, as inserted_ends has", std::to_string(ends.size())};
  }
  TraceEnd expected{list.ends_name, list.name, 0, list.bodies.size()};
  for (std::size_t frame = 0; frame < frames; ++frame) {
    if (Fault fault = find_fault(expected, ends[frame], frame, frame + 1 == frames)) return fault;
    expected.least = ends[frame];
  }
  return std::nullopt;
}

Fault find_fault_of_bodies(const Trace& trace) {
  const std::array<List, 3> lists = {{{"inserted", "inserted_ends", trace.inserted, trace.inserted_ends},
                                      {"removed", "removed_ends", trace.removed, trace.removed_ends},
                                      {"moved", "moved_ends", trace.moved, trace.moved_ends}}};
  for (const List& list : lists) {
    if (Fault fault = find_fault_of_ends(list, trace.frames())) return fault;
  }
  TraceCheck check(trace.inserted.size());
  for (std::size_t frame = 0; frame < trace.frames(); ++frame) {
    if (Fault fault = check.next(part_of(trace, frame))) return fault;
  }
  return std::nullopt;
}

Fault wrong_length(std::string_view list, std::size_t length, std::string_view of, std::size_t expected) {
  return TraceFault{list, std::min(length, expected), 0,
                    std::to_string(expected) + " elements, as " + std::string(of) + " has",
                    std::to_string(length)};
}

}  // namespace

std::string in_frame(const TraceFault& fault) {
  return " (frame " + std::to_string(fault.frame) + "): expected " + fault.expected + ", found " +
         fault.found;
}

std::optional<TraceFault> find_fault(const Trace& trace) {
  const std::size_t inserted = trace.inserted.size();
  if (trace.inserted_boxes.size() != inserted)
    return wrong_length("inserted_boxes", trace.inserted_boxes.size(), "inserted", inserted);
  if (!trace.inserted_filters.empty() && trace.inserted_filters.size() != inserted)
    return wrong_length("category", trace.inserted_filters.size(), "inserted", inserted);
  if (trace.moved_boxes.size() != trace.moved.size())
    return wrong_length("moved_boxes", trace.moved_boxes.size(), "moved", trace.moved.size());
  return find_fault_of_bodies(trace);
}

std::optional<TraceFault> find_fault(const TraceEnd& expected, std::uint64_t end, std::size_t frame,
                                     bool is_last) {
  const std::uint64_t all = expected.all;
  if (end >= expected.least && end <= all && (!is_last || end == all)) return std::nullopt;
  std::string what =
      is_last ? "the number of bodies in " + std::string(expected.name) + ", " + std::to_string(all)
              : "a number of " + std::to_string(expected.least) + " to " + std::to_string(all);
  return TraceFault{expected.ends_name, frame, frame, std::move(what), std::to_string(end)};
}

TraceCheck::TraceCheck(std::size_t all_inserted) : all_inserted_(all_inserted) {}

std::string_view TraceCheck::name_of(State state) {
  switch (state) {
    case State::present:
      return "which is there";
    case State::removed_now:
      return "which is removed in this frame";
    case State::inserted_now:
      return "which is inserted in this frame";
    default:
      return "which is not there";
  }
}

std::optional<TraceFault> TraceCheck::next(const TracePart& part) {
  const auto is_there = [](State state) { return state == State::present; };
  const auto is_free = [](State state) { return state == State::absent; };
  if (Fault fault = run_list("removed", part.removed, removed_, "a body that is there", is_there))
    return fault;
  set(part.removed, State::removed_now);
  if (Fault fault = make_room(part.inserted)) return fault;
  if (Fault fault = run_list("inserted", part.inserted, inserted_, "a body that is not there", is_free))
    return fault;
  set(part.inserted, State::inserted_now);
  if (Fault fault =
          run_list("moved", part.moved, moved_, "a body that was there in the frame before", is_there))
    return fault;
  set(part.removed, State::absent);
  set(part.inserted, State::present);
  ++frame_;
  inserted_ += part.inserted.size();
  removed_ += part.removed.size();
  moved_ += part.moved.size();
  return std::nullopt;
}

std::optional<TraceFault> TraceCheck::find_fault_of_id(std::size_t index, std::size_t frame, BodyId body,
                                                       std::size_t all_inserted) const {
  const std::size_t most = std::max(kFewIds, kIdsOfBody * all_inserted);
  if (body < most) return std::nullopt;
  return TraceFault{
      "inserted", index, frame,
      "an id below " + std::to_string(most) + " for " + std::to_string(all_inserted) + " bodies",
      std::to_string(body)};
}

std::optional<TraceFault> TraceCheck::make_room(std::span<const BodyId> inserted) {
  for (std::size_t i = 0; i < inserted.size(); ++i) {
    const BodyId body = inserted[i];
    if (body < states_.size()) continue;
    if (all_inserted_) {
      if (Fault fault = find_fault_of_id(inserted_ + i, frame_, body, *all_inserted_)) return fault;
    }
    states_.resize(body + std::size_t{1}, State::absent);
    index_of_largest_ = inserted_ + i;
    frame_of_largest_ = frame_;
  }
  return std::nullopt;
}

std::optional<TraceFault> TraceCheck::check_ids() const {
  if (states_.empty()) return std::nullopt;
  return find_fault_of_id(index_of_largest_, frame_of_largest_, static_cast<BodyId>(states_.size() - 1),
                          inserted_);
}

template <class IsGood>
std::optional<TraceFault> TraceCheck::run_list(std::string_view name, std::span<const BodyId> bodies,
                                               std::size_t first, const char* expected,
                                               IsGood&& is_good) const {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyId body = bodies[i];
    if (i > 0 && bodies[i - 1] >= body) {
      return TraceFault{name, first + i, frame_,
                        "an id above the one before it, " + std::to_string(bodies[i - 1]),
                        std::to_string(body)};
    }
    const State state = body < states_.size() ? states_[body] : State::absent;
    if (is_good(state)) continue;
    return TraceFault{name, first + i, frame_, expected,
                      std::to_string(body) + ", " + std::string(name_of(state))};
  }
  return std::nullopt;
}

void TraceCheck::set(std::span<const BodyId> bodies, State state) {
  for (const BodyId body : bodies) states_[body] = state;
}

}  // namespace cellsweep
