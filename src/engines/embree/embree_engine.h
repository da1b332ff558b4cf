/// @file
/// Engine `embree`: the tree of a ray tracer against itself (rtcCollide), for comparison.
#pragma once

#include <memory>
#include <vector>

#include "broadphase/checked_broadphase.h"
#include "cellsweep/engines.h"
#include "engines/embree/collider.h"

namespace cellsweep::embree {

/// Builds a tree over all boxes when anything changed, finds all pairs, and compares them with those before.
class EmbreeEngine final : public CheckedBroadphase {
 public:
  explicit EmbreeEngine(const EngineOptions& options) : collider_(options.threads) {}

  std::string_view name() const override { return "embree"; }
  Capacity capacity() const override;
  Result<PairChanges> update() override;
  std::span<const Pair> pairs() const override { return pairs_; }
  const Statistics& statistics() const override { return statistics_; }

 protected:
  void apply_insert(std::span<const Slot> slots, std::span<const Aabb> boxes) override;
  void apply_move(std::span<const Slot> slots, std::span<const Aabb> boxes) override;
  void apply_remove(std::span<const Slot> slots) override;

 private:
  void list_pairs();
  PairChanges compare_with_earlier();

  Collider collider_;
  std::vector<Aabb> boxes_;  // by slot; no_box() where none is
  bool changed_ = false;
  std::uint64_t builds_ = 0;
  std::vector<SlotPair> slot_pairs_;
  std::vector<Pair> pairs_;    // ascending
  std::vector<Pair> earlier_;  // those of the update before, ascending
  std::vector<Pair> began_;
  std::vector<Pair> ended_;
  Statistics statistics_;
};

}  // namespace cellsweep::embree

namespace cellsweep {

/// Makes an empty `embree`.
Result<std::unique_ptr<Broadphase>> make_embree(const EngineOptions& options);

}  // namespace cellsweep
