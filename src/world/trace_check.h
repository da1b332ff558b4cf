/// @file
/// What must hold of a trace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/world/trace.h"
#include "world/trace_part.h"

namespace cellsweep {

/// Which element of which list is wrong, and how.
struct TraceFault {
  std::string_view list;
  std::size_t index = 0;
  std::size_t frame = 0;
  std::string expected;
  std::string found;
};

/// " (frame 2): expected ..., found ...".
std::string in_frame(const TraceFault& fault);

/// The first fault of a trace whose boxes are good; nothing when it holds together.
std::optional<TraceFault> find_fault(const Trace& trace);

/// Where a frame's part of a list ends, by its name, among those before and behind it: from `least`, where
/// the last one ends, to `all`, the length of the list, which is where the last frame ends.
struct TraceEnd {
  std::string_view ends_name;
  std::string_view name;
  std::uint64_t least = 0;
  std::uint64_t all = 0;
};
std::optional<TraceFault> find_fault(const TraceEnd& expected, std::uint64_t end, std::size_t frame,
                                     bool is_last);

/// Follows the bodies of a trace from frame to frame.
class TraceCheck {
 public:
  /// Ids are allowed in proportion to the bodies that are inserted.
  explicit TraceCheck(std::size_t all_inserted);
  /// How many there will be is not known; check_ids() follows after the last frame.
  TraceCheck() = default;

  /// What is wrong with the next frame, whose lists are as long as each other demands; after that no more.
  std::optional<TraceFault> next(const TracePart& part);
  std::optional<TraceFault> check_ids() const;

  std::size_t frames() const { return frame_; }
  std::size_t inserted() const { return inserted_; }
  std::size_t removed() const { return removed_; }
  /// One more than the largest id.
  std::size_t ids() const { return states_.size(); }

 private:
  enum class State : unsigned char { absent, present, removed_now, inserted_now };

  static std::string_view name_of(State state);
  std::optional<TraceFault> make_room(std::span<const BodyId> inserted);
  std::optional<TraceFault> find_fault_of_id(std::size_t index, std::size_t frame, BodyId body,
                                             std::size_t all_inserted) const;
  template <class IsGood>
  std::optional<TraceFault> run_list(std::string_view name, std::span<const BodyId> bodies, std::size_t first,
                                     const char* expected, IsGood&& is_good) const;
  void set(std::span<const BodyId> bodies, State state);

  std::optional<std::size_t> all_inserted_;
  std::size_t frame_ = 0;
  std::size_t inserted_ = 0;  // of the frames before
  std::size_t removed_ = 0;
  std::size_t moved_ = 0;
  std::size_t index_of_largest_ = 0;
  std::size_t frame_of_largest_ = 0;
  std::vector<State> states_;  // by id
};

}  // namespace cellsweep
