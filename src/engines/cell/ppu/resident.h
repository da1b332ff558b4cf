/// @file
/// Engine `cell-resident`: SPU programs that stay alive, keep the bodies, and are told only what changed
/// (F1-F4).
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "broadphase/checked_broadphase.h"
#include "broadphase/pair_tracker.h"
#include "cellsweep/engines.h"
#include "engines/cell/emulation.h"
#include "engines/cell/ppu/layout.h"
#include "engines/cell/ppu/pose_log.h"
#include "engines/cell/ppu/resident_log.h"
#include "engines/cell/ppu/resident_spes.h"

namespace cellsweep::cell {

/// The document's future work (6.2). Each SPU keeps all bodies sorted along one axis from frame to frame, and
/// what it last knew of them is the collision status. An update sends what changed since the one before, in
/// up to three orders: bodies removed, moved, inserted. The SPUs share out the changed bodies, find each
/// one's pairs along their own axis, combine the axes there and send back the pairs that began and ended.
/// When nothing changed, no SPU hears of it (F4). With EngineOptions::spu_boxes a further order comes first
/// when bodies have new poses: each SPU encloses them on its own axis (F3).
class Resident final : public CheckedBroadphase {
 public:
  /// Starts the programs. Errors: bad_option for less than 3 or more than 16 SPUs and for a local store
  /// without room for a body, spe_failed.
  static Result<std::unique_ptr<Broadphase>> make(const EngineOptions& options,
                                                  std::shared_ptr<Emulation> emulation);

  std::string_view name() const override { return "cell-resident"; }
  Capacity capacity() const override { return capacity_; }
  Result<PairChanges> update() override;
  std::span<const Pair> pairs() const override { return tracker_.pairs(); }
  const Statistics& statistics() const override { return statistics_; }
  Status boxes(std::span<const BodyId> ids, std::span<Aabb> boxes) const override;

 protected:
  void apply_insert(std::span<const Slot> slots, std::span<const Aabb> boxes) override;
  void apply_move(std::span<const Slot> slots, std::span<const Aabb> boxes) override;
  void apply_remove(std::span<const Slot> slots) override;
  bool takes_poses() const override { return !spes_->poses().empty(); }
  void apply_insert_poses(std::span<const Slot> slots, std::span<const BodyPose> poses) override;
  void apply_move_poses(std::span<const Slot> slots, std::span<const BodyPose> poses) override;

 private:
  Resident(std::unique_ptr<ResidentSpes> spes, Capacity capacity);
  Status make_boxes();
  Status send(ResidentOrder order, std::span<const Slot> slots);
  void note_events();
  void refresh_counters();

  std::unique_ptr<ResidentSpes> spes_;
  Capacity capacity_;
  ResidentLog log_;
  PoseLog poses_;
  std::vector<BodyId> names_;              // by slot, of the bodies that the SPUs know
  std::vector<std::optional<Aabb>> told_;  // by slot, the boxes that the SPUs know
  PairTracker tracker_;
  Status failure_;  // of the SPEs; they do not come back
  std::uint64_t bodies_sent_ = 0;
  std::uint64_t poses_sent_ = 0;
  std::uint64_t events_ = 0;
  Statistics statistics_;
};

/// What an SPU of cell-resident allocates.
std::vector<LocalStorePart> resident_buffers(const EngineOptions& options, std::uint64_t bodies);

}  // namespace cellsweep::cell
