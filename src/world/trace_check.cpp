#include "world/trace_check.h"

#include <algorithm>
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

  std::size_t first(std::size_t frame) const { return frame == 0 ? 0 : ends[frame - 1]; }
};

Fault find_fault_of_ends(const List& list, std::size_t frames) {
  const auto& ends = list.ends;
  if (ends.empty()) return TraceFault{list.ends_name, 0, 0, "at least one frame", "none"};
  if (ends.size() != frames) {
    return TraceFault{list.ends_name, std::min(ends.size(), frames), 0,
                      std::to_string(frames) + " frames, as inserted_ends has", std::to_string(ends.size())};
  }
  for (std::size_t frame = 0; frame < frames; ++frame) {
    const std::size_t least = list.first(frame);
    const std::size_t most = list.bodies.size();
    if (ends[frame] >= least && ends[frame] <= most && (frame + 1 < frames || ends[frame] == most)) continue;
    return TraceFault{list.ends_name, frame, frame,
                      frame + 1 == frames
                          ? "the number of bodies in " + std::string(list.name) + ", " + std::to_string(most)
                          : "a number of " + std::to_string(least) + " to " + std::to_string(most),
                      std::to_string(ends[frame])};
  }
  return std::nullopt;
}

enum class State : unsigned char { absent, present, removed_now, inserted_now };

std::string_view name_of(State state) {
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

/// Follows the bodies through the frames.
class BodyCheck {
 public:
  explicit BodyCheck(const Trace& trace)
      : inserted_{"inserted", "inserted_ends", trace.inserted, trace.inserted_ends},
        removed_{"removed", "removed_ends", trace.removed, trace.removed_ends},
        moved_{"moved", "moved_ends", trace.moved, trace.moved_ends} {}

  Fault run() {
    const std::size_t frames = inserted_.ends.size();
    for (const List* list : {&inserted_, &removed_, &moved_}) {
      if (Fault fault = find_fault_of_ends(*list, frames)) return fault;
    }
    const std::size_t most = std::max(kFewIds, kIdsOfBody * inserted_.bodies.size());
    for (std::size_t frame = 0; frame < frames; ++frame) {
      if (Fault fault = run_frame(frame, most)) return fault;
    }
    return std::nullopt;
  }

 private:
  Fault run_frame(std::size_t frame, std::size_t most) {
    const auto is_there = [](State state) { return state == State::present; };
    if (Fault fault = run_list(removed_, frame, "a body that is there", is_there)) return fault;
    set(removed_, frame, State::removed_now);
    for (std::size_t i = inserted_.first(frame); i < inserted_.ends[frame]; ++i) {
      const BodyId body = inserted_.bodies[i];
      if (body >= most) {
        return TraceFault{"inserted", i, frame,
                          "an id below " + std::to_string(most) + " for " +
                              std::to_string(inserted_.bodies.size()) + " bodies",
                          std::to_string(body)};
      }
      if (body >= states_.size()) states_.resize(body + std::size_t{1}, State::absent);
    }
    const auto is_free = [](State state) { return state == State::absent; };
    if (Fault fault = run_list(inserted_, frame, "a body that is not there", is_free)) return fault;
    set(inserted_, frame, State::inserted_now);
    if (Fault fault = run_list(moved_, frame, "a body that was there in the frame before", is_there))
      return fault;
    set(removed_, frame, State::absent);
    set(inserted_, frame, State::present);
    return std::nullopt;
  }

  template <class IsGood>
  Fault run_list(const List& list, std::size_t frame, const char* expected, IsGood&& is_good) const {
    for (std::size_t i = list.first(frame); i < list.ends[frame]; ++i) {
      const BodyId body = list.bodies[i];
      if (i > list.first(frame) && list.bodies[i - 1] >= body) {
        return TraceFault{list.name, i, frame,
                          "an id above the one before it, " + std::to_string(list.bodies[i - 1]),
                          std::to_string(body)};
      }
      const State state = body < states_.size() ? states_[body] : State::absent;
      if (is_good(state)) continue;
      return TraceFault{list.name, i, frame, expected,
                        std::to_string(body) + ", " + std::string(name_of(state))};
    }
    return std::nullopt;
  }

  void set(const List& list, std::size_t frame, State state) {
    for (std::size_t i = list.first(frame); i < list.ends[frame]; ++i) states_[list.bodies[i]] = state;
  }

  List inserted_;
  List removed_;
  List moved_;
  std::vector<State> states_;  // by id
};

Fault wrong_length(std::string_view list, std::size_t length, std::string_view of, std::size_t expected) {
  return TraceFault{list, std::min(length, expected), 0,
                    std::to_string(expected) + " elements, as " + std::string(of) + " has",
                    std::to_string(length)};
}

}  // namespace

std::optional<TraceFault> find_fault(const Trace& trace) {
  const std::size_t inserted = trace.inserted.size();
  if (trace.inserted_boxes.size() != inserted)
    return wrong_length("inserted_boxes", trace.inserted_boxes.size(), "inserted", inserted);
  if (!trace.inserted_filters.empty() && trace.inserted_filters.size() != inserted)
    return wrong_length("category", trace.inserted_filters.size(), "inserted", inserted);
  if (trace.moved_boxes.size() != trace.moved.size())
    return wrong_length("moved_boxes", trace.moved_boxes.size(), "moved", trace.moved.size());
  return BodyCheck(trace).run();
}

}  // namespace cellsweep
