#include "engines/cell/ppu/resident.h"

#include <algorithm>

#include "base/text.h"
#include "cellsweep/engine/phase_timer.h"
#include "geometry/canonical.h"

namespace cellsweep::cell {
namespace {

constexpr unsigned kAxes = 3;
constexpr unsigned kMostSpus = 16;
constexpr std::uint32_t kSlotMask = (1U << kResidentSlotBits) - 1;

ResidentRecord record_of(Slot slot, const Aabb& box) {
  return {{box.min[0], box.min[1], box.min[2]}, slot, {box.max[0], box.max[1], box.max[2]}, 0};
}

Status no_room_status(const Capacity& capacity, std::uint64_t limit) {
  return {
      StatusCode::bad_option,
      text("cell-resident cannot hold a single body: ", capacity.reason, "; raise ", capacity.setting, "."),
      std::nullopt,
      limit,
      0,
      capacity.setting};
}

}  // namespace

std::vector<LocalStorePart> resident_buffers(const EngineOptions& options, std::uint64_t bodies) {
  const std::uint64_t room = (bodies + 15) / 16 * 16;
  const std::uint64_t changes = resident_changes(bodies);
  std::vector<LocalStorePart> parts = {{"job", sizeof(ResidentJob)},
                                       {"sorted boxes", room * 28},
                                       {"reach of boxes", room},
                                       {"places of bodies", room * 2},
                                       {"changed boxes", changes * 32},
                                       {"changed boxes before", changes * 32},
                                       {"order of changed boxes", changes * 8},
                                       {"events", 2 * kResidentEventChunk * 4},
                                       {"gaps for alignment", 8 * kDmaAlign}};
  if (!options.spu_boxes) return parts;
  parts.push_back({"poses", 2 * kPosePiece * sizeof(PoseBlock) + kDmaAlign});
  parts.push_back({"intervals of poses", 2 * kPosePiece * sizeof(IntervalBlock) + kDmaAlign});
  return parts;
}

Result<std::unique_ptr<Broadphase>> Resident::make(const EngineOptions& options,
                                                   std::shared_ptr<Emulation> emulation) {
  const unsigned spus = options.spus == 0 ? kAxes : options.spus;
  if (spus < kAxes || spus > kMostSpus) {
    return Status{StatusCode::bad_option,
                  text("spus is ", spus, "; cell-resident uses from ", kAxes, ", one for each axis, to ",
                       kMostSpus, "."),
                  std::nullopt,
                  spus,
                  spus < kAxes ? kAxes : kMostSpus,
                  "spus"};
  }
  const auto buffers = [&](std::uint64_t count) { return resident_buffers(options, count); };
  Capacity capacity = local_store_capacity("cell-resident", emulation->local_store(), buffers, kResidentSlots,
                                           text("an event names a body in ", kResidentSlotBits, " bits"));
  if (capacity.bodies == 0) return no_room_status(capacity, emulation->local_store().limit);
  auto spes = ResidentSpes::start({spus, capacity.bodies, options.spu_boxes}, std::move(emulation));
  if (!spes) return spes.status();
  return std::unique_ptr<Broadphase>(new Resident(std::move(*spes), std::move(capacity)));
}

Resident::Resident(std::unique_ptr<ResidentSpes> spes, Capacity capacity)
    : spes_(std::move(spes)), capacity_(std::move(capacity)) {}

void Resident::apply_insert(std::span<const Slot> slots, std::span<const Aabb> boxes) {
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (slots[i] >= told_.size()) told_.resize(slots[i] + 1);
    told_[slots[i]].reset();
    log_.insert(slots[i], boxes[i]);
  }
}

void Resident::apply_move(std::span<const Slot> slots, std::span<const Aabb> boxes) {
  for (std::size_t i = 0; i < slots.size(); ++i) {
    poses_.forget(slots[i]);
    log_.move(slots[i], boxes[i]);
  }
}

void Resident::apply_remove(std::span<const Slot> slots) {
  for (const Slot slot : slots) {
    poses_.forget(slot);
    log_.remove(slot);
  }
}

// The boxes come with the next update.
void Resident::apply_insert_poses(std::span<const Slot> slots, std::span<const BodyPose> poses) {
  apply_insert(slots, std::vector<Aabb>(slots.size()));
  apply_move_poses(slots, poses);
}

void Resident::apply_move_poses(std::span<const Slot> slots, std::span<const BodyPose> poses) {
  for (std::size_t i = 0; i < slots.size(); ++i) poses_.set(slots[i], poses[i]);
}

Status Resident::boxes(std::span<const BodyId> ids, std::span<Aabb> boxes) const {
  if (!takes_poses()) return Broadphase::boxes(ids, boxes);
  if (ids.size() != boxes.size()) return length_status(ids.size(), boxes.size());
  const auto told = [&](BodyId id) {
    const Slot slot = bodies().find(id);
    return slot == kNoSlot ? std::nullopt : told_[slot];
  };
  for (const BodyId id : ids) {
    if (!told(id)) return unknown_body_status(id);
  }
  for (std::size_t i = 0; i < ids.size(); ++i) boxes[i] = *told(ids[i]);
  return {};
}

Result<PairChanges> Resident::update() {
  if (!failure_.ok()) return failure_;
  PhaseTimer timer(statistics_.phases);
  if (takes_poses()) {
    failure_ = make_boxes();
    if (!failure_.ok()) return failure_;
    timer.lap("boxes");
  }
  if (!log_.empty()) {
    failure_ = send(ResidentOrder::remove, log_.removed());
    if (failure_.ok()) failure_ = send(ResidentOrder::move, log_.moved());
    if (failure_.ok()) failure_ = send(ResidentOrder::insert, log_.inserted());
    if (!failure_.ok()) return failure_;
    log_.clear();
  }
  timer.lap("spus");
  const PairChanges changes = tracker_.commit();
  timer.lap("collect changes");
  ++statistics_.updates;
  refresh_counters();
  statistics_.cell = spes_->take_cell_time();
  return changes;
}

Status Resident::make_boxes() {
  const std::span<const Slot> slots = poses_.pending();
  if (slots.empty()) return {};
  poses_.pack(spes_->poses());
  const auto count = static_cast<std::uint32_t>(slots.size());
  if (Status status = spes_->obey(ResidentOrder::bound, count); !status.ok()) return status;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    Aabb box;
    for (unsigned axis = 0; axis < kAxes; ++axis) {
      const IntervalBlock& four = spes_->intervals(axis)[i / kLanes];
      box.min[axis] = four.low[i % kLanes];
      box.max[axis] = four.high[i % kLanes];
    }
    log_.move(slots[i], box);
  }
  poses_sent_ += slots.size();
  poses_.clear_pending();
  return {};
}

// An order that is too long becomes several: each leaves pairs right, so that the last one leaves them right
// for all.
Status Resident::send(ResidentOrder order, std::span<const Slot> slots) {
  const std::span<ResidentRecord> records = spes_->records();
  while (!slots.empty()) {
    const std::size_t now = std::min(slots.size(), records.size());
    for (std::size_t i = 0; i < now; ++i) {
      records[i] = record_of(slots[i], log_.box(slots[i]));
      if (order != ResidentOrder::remove) told_[slots[i]] = log_.box(slots[i]);
      if (order != ResidentOrder::insert) continue;
      if (slots[i] >= names_.size()) names_.resize(slots[i] + 1);
      names_[slots[i]] = bodies().id(slots[i]);
    }
    if (Status status = spes_->obey(order, static_cast<std::uint32_t>(now)); !status.ok()) return status;
    note_events();
    bodies_sent_ += now;
    slots = slots.subspan(now);
  }
  return {};
}

void Resident::note_events() {
  for (unsigned spu = 0; spu < spes_->size(); ++spu) {
    for (const std::uint32_t event : spes_->events(spu)) {
      const BodyId one = names_[(event >> kResidentSlotBits) & kSlotMask];
      const BodyId other = names_[event & kSlotMask];
      tracker_.note(make_pair_of(one, other), (event & kResidentBegan) != 0);
    }
    events_ += spes_->events(spu).size();
  }
}

void Resident::refresh_counters() {
  const SpeCounts counts = spes_->counts();
  statistics_.counters = {{"programs started", spes_->starts()},
                          {"mailbox words", spes_->mailbox_words()},
                          {"bodies sent", bodies_sent_},
                          {"poses sent", poses_sent_},
                          {"events", events_},
                          {"dma gets", counts.gets},
                          {"dma puts", counts.puts},
                          {"dma bytes in", counts.bytes_in},
                          {"dma bytes out", counts.bytes_out},
                          {"local store high water", counts.local_store_high_water}};
}

}  // namespace cellsweep::cell
