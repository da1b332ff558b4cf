/// @file
/// Engine `cell-paper`: the document's Cell version (chapter 4.2), step by step.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "broadphase/checked_broadphase.h"
#include "broadphase/pair_tracker.h"
#include "cellsweep/engines.h"
#include "engines/cell/emulation.h"
#include "engines/cell/ppu/layout.h"
#include "engines/cell/ppu/paper_axis.h"
#include "engines/cell/ppu/paper_pairs.h"
#include "engines/cell/ppu/spe_group.h"

namespace cellsweep::cell {

/// What the SPU of one axis allocates (C14).
std::vector<LocalStorePart> paper_buffers(const EngineOptions& options, std::uint64_t bodies);

/// Three axes on three SPUs, whose threads start each frame (C1); they sort, find what changed and which IDs
/// overlap it; the host applies their keys to its pair manager (C15). Exact unless made with `literal`.
class Paper final : public CheckedBroadphase {
 public:
  static Result<std::unique_ptr<Broadphase>> make(const EngineOptions& options,
                                                  std::shared_ptr<Emulation> emulation);

  std::string_view name() const override { return "cell-paper"; }
  Capacity capacity() const override { return capacity_; }
  Result<PairChanges> update() override;
  std::span<const Pair> pairs() const override { return tracker_.pairs(); }
  const Statistics& statistics() const override { return statistics_; }

 protected:
  void apply_insert(std::span<const Slot> slots, std::span<const Aabb> boxes) override;
  void apply_move(std::span<const Slot> slots, std::span<const Aabb> boxes) override;
  void apply_remove(std::span<const Slot> slots) override;

 private:
  Paper(const EngineOptions& options, std::unique_ptr<SpeGroup> spes, Capacity capacity);
  void enter_new_bodies();
  void fill_arrays();
  Status run_spus();
  void update_pairs(std::size_t axis);
  void note_changed_pairs();
  void refresh_counters();

  EngineOptions options_;
  std::unique_ptr<SpeGroup> spes_;
  Capacity capacity_;
  std::vector<Aabb> boxes_;           // by slot
  std::vector<std::uint32_t> slots_;  // in use, ascending, as of the last rebuild
  std::vector<bool> in_use_;          // by slot
  std::vector<Slot> new_slots_;       // inserted since the last update: their pairs are not in the map yet
  bool rebuild_ = true;               // C2: bodies came or went, or a frame failed
  std::vector<PaperAxis> axes_;
  PaperPairs pairs_;
  PaperPairs::Changed changed_pairs_;
  PairTracker tracker_;
  std::uint64_t changed_ids_ = 0;
  std::uint64_t keys_ = 0;
  Statistics statistics_;
};

}  // namespace cellsweep::cell
