/// @file
/// Engine `cell-brute`: every changed body against all others in SIMD on the SPUs, no sort.
#pragma once

#include <libspe2.h>

#include <memory>
#include <vector>

#include "broadphase/checked_broadphase.h"
#include "broadphase/pair_tracker.h"
#include "cellsweep/engines.h"
#include "engines/cell/emulation.h"
#include "engines/cell/ppu/dma_memory.h"
#include "engines/cell/ppu/layout.h"
#include "engines/cell/ppu/overlap_matrix.h"
#include "engines/cell/ppu/spe_group.h"

namespace cellsweep::cell {

/// What an SPU of cell-brute allocates.
std::vector<LocalStorePart> brute_buffers(std::uint64_t bodies);

/// What the document cites from Bullet's port to the Cell (2.6.2). All boxes go to every SPU, changed bodies
/// are shared out; each comes back as a row of overlap bits, and the host tells what differs from the row
/// before.
class Brute final : public CheckedBroadphase {
 public:
  static Result<std::unique_ptr<Broadphase>> make(const EngineOptions& options,
                                                  std::shared_ptr<Emulation> emulation);

  std::string_view name() const override { return "cell-brute"; }
  Capacity capacity() const override { return capacity_; }
  Result<PairChanges> update() override;
  std::span<const Pair> pairs() const override { return tracker_.pairs(); }
  const Statistics& statistics() const override { return statistics_; }

 protected:
  void apply_insert(std::span<const Slot> slots, std::span<const Aabb> boxes) override;
  void apply_move(std::span<const Slot> slots, std::span<const Aabb> boxes) override;
  void apply_remove(std::span<const Slot> slots) override;

 private:
  Brute(std::unique_ptr<SpeGroup> spes, Capacity capacity);
  void make_room();
  void set_box(Slot slot, const Aabb& box);
  void list_changed();
  std::vector<void*> prepare_jobs();
  void note_rows();
  void refresh_counters();

  std::unique_ptr<SpeGroup> spes_;
  Capacity capacity_;
  std::uint32_t stride_ = 0;  // bodies with room in the arrays, a multiple of kBruteBlock
  DmaVector<float> boxes_;    // as BruteJob says
  std::vector<Slot> touched_;
  std::vector<bool> is_touched_;                  // by slot
  std::vector<Slot> changed_;                     // touched_ without the slots that are empty now
  std::vector<DmaVector<std::uint32_t>> shares_;  // changed_, by SPU
  std::vector<DmaVector<std::uint32_t>> rows_;    // by SPU
  DmaVector<BruteJob> jobs_;
  OverlapMatrix overlaps_;
  PairTracker tracker_;
  std::uint64_t tested_ = 0;
  Statistics statistics_;
};

}  // namespace cellsweep::cell
