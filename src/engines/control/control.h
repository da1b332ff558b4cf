/// @file
/// Engine `control`: the document's x86 sweep and prune (chapter 4.1), the yardstick of its experiment.
#pragma once

#include <array>
#include <deque>
#include <vector>

#include "cellsweep/options.h"
#include "engines/common/pair_tracker.h"
#include "engines/common/placed_engine.h"
#include "engines/control/pair_manager.h"
#include "engines/control/sort_and_test.h"

namespace cellsweep::control {

/// Three endpoint lists kept sorted from frame to frame, and a map of all possible pairs (X1-X6). One thread.
/// Memory grows with the square of the bodies, so the size of the map is limited.
class Control final : public PlacedEngine {
 public:
  explicit Control(const ControlOptions& options);

  Capacity capacity() const override;

 protected:
  void apply_insert(std::span<const Slot> places, std::span<const Aabb> boxes) override;
  void apply_move(std::span<const Slot> places, std::span<const Aabb> boxes) override;
  void apply_remove(std::span<const Slot> places) override;
  Result<FoundPairs> find_pairs(Statistics& statistics) override;

 private:
  void fill_pair_map();
  void append_endpoints();
  void sort_axis(int axis);
  void note_changed_pairs();
  void forget_pairs_of(Slot place);
  SlotPair pair_of(const PairInfo& info) const;

  ControlOptions options_;
  std::deque<Aabb> boxes_;        // by place; a deque, because endpoints point into it
  std::vector<Slot> entered_;     // places whose pairs are in the map, in the order they entered
  std::vector<Slot> new_places_;  // places of bodies that are new, not in the map yet
  std::array<EndpointList, 3> axes_;
  PairManager pair_manager_;
  PairTracker tracker_;
  std::vector<PairInfo> changed_;
  std::uint64_t swaps_ = 0;
};

}  // namespace cellsweep::control
