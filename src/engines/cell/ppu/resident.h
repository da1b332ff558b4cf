/// @file
/// Engine `cell-resident`: SPU programs that stay alive, keep the bodies, and are told only what changed
/// (F1-F4).
#pragma once

#include <memory>
#include <vector>

#include "cellsweep/cell.h"
#include "engines/cell/cell_engine.h"
#include "engines/cell/emulation.h"
#include "engines/cell/ppu/layout.h"
#include "engines/cell/ppu/resident_spes.h"
#include "engines/common/pair_tracker.h"
#include "engines/common/placed_engine.h"

namespace cellsweep::cell {

/// The document's future work (6.2). Each SPU keeps all bodies sorted along one axis from frame to frame, and
/// what it last knew of them is the collision status. An update sends what changed since the one before, in
/// up to three orders: bodies removed, moved, inserted. The SPUs share out the changed bodies, find each
/// one's pairs along their own axis, combine the axes there and send back the pairs that began and ended.
/// When nothing changed, no SPU hears of it (F4). With CellResidentOptions::spu_boxes there is a further
/// order between updates: each SPU encloses poses on its own axis (F3).
class Resident final : public PlacedEngine, public CellEngine, public PoseBoxes {
 public:
  /// Starts the programs. Errors: bad_option for less than 3 or more than 16 SPUs, capacity for a local store
  /// without room for a body, spe_failed.
  static Result<std::unique_ptr<Engine>> make(const CellResidentOptions& options,
                                              std::shared_ptr<Emulation> emulation);

  Capacity capacity() const override { return capacity_; }
  const CellStatistics& cell_statistics() const override { return cell_statistics_; }
  bool ran_out_of_memory() const override { return spes_->ran_out_of_memory(); }
  bool takes_poses() const override { return !spes_->poses().empty(); }
  Status make_boxes(std::span<const BodyPose> poses, std::span<Aabb> boxes) override;

 protected:
  void apply_remove(std::span<const Slot> places) override;
  void apply_move(std::span<const Slot> places, std::span<const Aabb> boxes) override;
  void apply_insert(std::span<const Slot> places, std::span<const Aabb> boxes) override;
  Result<FoundPairs> find_pairs(Statistics& statistics) override;

 private:
  Resident(std::unique_ptr<ResidentSpes> spes, Capacity capacity);
  Status tell_changes();
  Status send(ResidentOrder order, std::span<const ResidentRecord> records);
  void note_events();
  void take_boxes(std::span<Aabb> boxes) const;
  void refresh(Statistics& statistics);

  std::unique_ptr<ResidentSpes> spes_;
  Capacity capacity_;
  std::vector<Aabb> boxes_;  // by place
  std::vector<ResidentRecord> removed_;
  std::vector<ResidentRecord> moved_;
  std::vector<ResidentRecord> inserted_;
  std::vector<Slot> names_;  // by place, of the bodies that the SPUs know
  PairTracker tracker_;
  CellStatistics cell_statistics_;
  std::uint64_t bodies_sent_ = 0;
  std::uint64_t poses_sent_ = 0;
  std::uint64_t events_ = 0;
};

/// Errors: bad_option.
Status check(const CellResidentOptions& options);

/// What an SPU of cell-resident allocates.
std::vector<LocalStorePart> resident_buffers(const CellResidentOptions& options, std::uint64_t bodies);

}  // namespace cellsweep::cell
