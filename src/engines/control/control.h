/// @file
/// Engine `control`: the document's x86 sweep and prune (chapter 4.1), the yardstick of its experiment.
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <vector>

#include "broadphase/checked_broadphase.h"
#include "broadphase/pair_tracker.h"
#include "cellsweep/engines.h"
#include "engines/control/pair_manager.h"
#include "engines/control/sort_and_test.h"

namespace cellsweep::control {

/// Three endpoint lists kept sorted from frame to frame, and a map of all possible pairs (X1-X6). One thread.
/// Memory grows with the square of the bodies, so the size of the map is limited.
class Control final : public CheckedBroadphase {
 public:
  explicit Control(const EngineOptions& options);

  std::string_view name() const override { return "control"; }
  Capacity capacity() const override;
  Result<PairChanges> update() override;
  std::span<const Pair> pairs() const override { return tracker_.pairs(); }
  const Statistics& statistics() const override { return statistics_; }

 protected:
  void apply_insert(std::span<const Slot> slots, std::span<const Aabb> boxes) override;
  void apply_move(std::span<const Slot> slots, std::span<const Aabb> boxes) override;
  void apply_remove(std::span<const Slot> slots) override;

 private:
  void fill_pair_map();
  void append_endpoints();
  void sort_axis(int axis);
  void note_changed_pairs();
  void forget_pairs_of(Slot slot);
  void refresh_counters();
  Pair pair_of(const PairInfo& info) const;

  EngineOptions options_;
  std::deque<Aabb> boxes_;       // by slot; a deque, because endpoints point into it
  std::vector<Slot> entered_;    // slots whose pairs are in the map, in the order they entered
  std::vector<Slot> new_slots_;  // slots inserted since the last update, not in the map yet
  std::array<EndpointList, 3> axes_;
  PairManager pair_manager_;
  PairTracker tracker_;
  std::vector<PairInfo> changed_;
  std::uint64_t swaps_ = 0;
  Statistics statistics_;
};

}  // namespace cellsweep::control

namespace cellsweep {

/// Makes an empty `control`. Errors: bad_option when the pair map is allowed less than one entry.
Result<std::unique_ptr<Broadphase>> make_control(const EngineOptions& options);

}  // namespace cellsweep
