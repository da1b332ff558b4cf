/// @file
/// Engine `cell-brute`: every changed body against all others in SIMD on the SPUs, no sort.
#pragma once

#include <memory>
#include <vector>

#include "cellsweep/cell.h"
#include "engines/cell/cell_engine.h"
#include "engines/cell/emulation.h"
#include "engines/cell/ppu/dma_memory.h"
#include "engines/cell/ppu/layout.h"
#include "engines/cell/ppu/overlap_matrix.h"
#include "engines/cell/ppu/spe_group.h"
#include "engines/common/pair_tracker.h"
#include "engines/common/placed_engine.h"

namespace cellsweep::cell {

/// Errors: bad_option.
Status check(const CellBruteOptions& options);

/// What an SPU of cell-brute allocates.
std::vector<LocalStorePart> brute_buffers(std::uint64_t bodies);

/// What the document cites from Bullet's port to the Cell (2.6.2). All boxes go to every SPU, changed bodies
/// are shared out; each comes back as a row of overlap bits, and the host tells what differs from the row
/// before.
class Brute final : public PlacedEngine, public CellEngine {
 public:
  /// Errors: bad_option for more than 16 SPUs, capacity for a local store without room for a body,
  /// spe_failed.
  static Result<std::unique_ptr<Engine>> make(const CellBruteOptions& options,
                                              std::shared_ptr<Emulation> emulation);

  Capacity capacity() const override { return capacity_; }
  const CellStatistics& cell_statistics() const override { return cell_statistics_; }

 protected:
  void apply_remove(std::span<const Slot> places) override;
  void apply_move(std::span<const Slot> places, std::span<const Aabb> boxes) override;
  void apply_insert(std::span<const Slot> places, std::span<const Aabb> boxes) override;
  Result<FoundPairs> find_pairs(Statistics& statistics) override;

 private:
  Brute(std::unique_ptr<SpeGroup> spes, Capacity capacity);
  void make_room();
  void set_box(Slot place, const Aabb& box);
  std::vector<void*> prepare_jobs();
  void note_rows();
  void refresh(Statistics& statistics);

  std::unique_ptr<SpeGroup> spes_;
  Capacity capacity_;
  std::uint32_t stride_ = 0;                      // bodies with room in the arrays, a multiple of kBruteBlock
  DmaVector<float> boxes_;                        // as BruteJob says
  std::vector<Slot> changed_;                     // places of bodies that moved or are new
  std::vector<DmaVector<std::uint32_t>> shares_;  // changed_, by SPU
  std::vector<DmaVector<std::uint32_t>> rows_;    // by SPU
  DmaVector<BruteJob> jobs_;
  OverlapMatrix overlaps_;
  PairTracker tracker_;
  CellStatistics cell_statistics_;
  std::uint64_t tested_ = 0;
};

}  // namespace cellsweep::cell
