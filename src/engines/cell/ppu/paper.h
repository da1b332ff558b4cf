/// @file
/// Engine `cell-paper`: the document's Cell version (chapter 4.2), step by step.
#pragma once

#include <memory>
#include <vector>

#include "cellsweep/cell.h"
#include "engines/cell/cell_engine.h"
#include "engines/cell/emulation.h"
#include "engines/cell/ppu/layout.h"
#include "engines/cell/ppu/paper_axis.h"
#include "engines/cell/ppu/paper_pairs.h"
#include "engines/cell/ppu/spe_group.h"
#include "engines/common/pair_tracker.h"
#include "engines/common/placed_engine.h"

namespace cellsweep::cell {

/// Errors: bad_option.
Status check(const CellPaperOptions& options);

/// What the SPU of one axis allocates (C14).
std::vector<LocalStorePart> paper_buffers(const CellPaperOptions& options, std::uint64_t bodies);

/// Three axes on three SPUs, whose threads start each frame (C1); they sort, find what changed and which IDs
/// overlap it; the host applies their keys to its pair manager (C15). Exact unless made with `literal`.
class Paper final : public PlacedEngine, public CellEngine {
 public:
  /// Errors: bad_option, capacity for a local store without room for a body, spe_failed.
  static Result<std::unique_ptr<Engine>> make(const CellPaperOptions& options,
                                              std::shared_ptr<Emulation> emulation);

  Capacity capacity() const override { return capacity_; }
  const CellStatistics& cell_statistics() const override { return cell_statistics_; }

 protected:
  void apply_remove(std::span<const Slot> places) override;
  void apply_move(std::span<const Slot> places, std::span<const Aabb> boxes) override;
  void apply_insert(std::span<const Slot> places, std::span<const Aabb> boxes) override;
  Result<FoundPairs> find_pairs(Statistics& statistics) override;

 private:
  Paper(const CellPaperOptions& options, std::unique_ptr<SpeGroup> spes, Capacity capacity);
  void enter_new_bodies();
  void fill_arrays();
  Status run_spus();
  void update_pairs(std::size_t axis);
  void note_changed_pairs();
  void refresh(Statistics& statistics);

  CellPaperOptions options_;
  std::unique_ptr<SpeGroup> spes_;
  Capacity capacity_;
  std::vector<Aabb> boxes_;       // by place
  std::vector<bool> in_use_;      // by place
  std::vector<Slot> used_;        // places in use, ascending, as of the last rebuild
  std::vector<Slot> new_places_;  // of bodies whose pairs are not in the map yet
  bool rebuild_ = true;           // C2: bodies came or went
  std::vector<PaperAxis> axes_;
  PaperPairs pairs_;
  PaperPairs::Changed changed_pairs_;
  PairTracker tracker_;
  CellStatistics cell_statistics_;
  std::uint64_t changed_ids_ = 0;
  std::uint64_t keys_ = 0;
};

}  // namespace cellsweep::cell
