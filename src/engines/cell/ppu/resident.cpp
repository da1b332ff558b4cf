#include "engines/cell/ppu/resident.h"

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "cellsweep/engine/phase_timer.h"
#include "engines/cell/ppu/pose_blocks.h"
#include "engines/cell/ppu/spe_counts.h"

namespace cellsweep::cell {
namespace {

constexpr std::uint32_t kPlaceMask = (1U << kResidentSlotBits) - 1;

ResidentRecord record_of(Slot place, const Aabb& box) {
  return {{box.min[0], box.min[1], box.min[2]}, place, {box.max[0], box.max[1], box.max[2]}, 0};
}

}  // namespace

std::vector<LocalStorePart> resident_buffers(const CellResidentOptions& options, std::uint64_t bodies) {
  const std::uint64_t room = (bodies + 15) / 16 * 16;
  const std::uint64_t changes = resident_changes(bodies);
  std::vector<LocalStorePart> parts = {{"job", sizeof(ResidentJob)},
                                       {"sorted boxes", room * 28},
                                       {"reach of boxes", room},
                                       {"places of bodies", room * 2},
                                       {"changed boxes", changes * 32},
                                       {"changed boxes before", changes * 32},
                                       {"order of changed boxes", changes * 8},
                                       {"events", sizeof(std::uint32_t) * 2 * kResidentEventChunk},
                                       {"gaps for alignment", std::uint64_t{8} * kDmaAlign}};
  if (!options.spu_boxes) return parts;
  parts.push_back({"poses", sizeof(PoseBlock) * 2 * kPosePiece + kDmaAlign});
  parts.push_back({"intervals of poses", sizeof(IntervalBlock) * 2 * kPosePiece + kDmaAlign});
  return parts;
}

Status check(const CellResidentOptions& options) {
  const unsigned spus = options.spus;
  if (spus == 0 || (spus >= kAxes && spus <= kMostSpus)) return {};
  return Status::bad_option(
      "spus",
      text("spus is ", spus, "; cell-resident uses from ", kAxes, ", one for each axis, to ", kMostSpus, "."),
      spus, spus < kAxes ? kAxes : kMostSpus);
}

Result<std::unique_ptr<Engine>> Resident::make(const CellResidentOptions& options,
                                               std::shared_ptr<Emulation> emulation) {
  if (Status status = check(options); !status.ok()) return status;
  const auto buffers = [&](std::uint64_t count) { return resident_buffers(options, count); };
  auto capacity = local_store_capacity("cell-resident", emulation->local_store(), buffers, kResidentSlots,
                                       text("an event names a body in ", kResidentSlotBits, " bits"));
  if (!capacity) return capacity.status();
  const unsigned spus = options.spus == 0 ? kAxes : options.spus;
  auto spes = ResidentSpes::start({spus, capacity->bodies, options.spu_boxes}, std::move(emulation));
  if (!spes) return spes.status();
  return std::unique_ptr<Engine>(new Resident(std::move(*spes), std::move(*capacity)));
}

Resident::Resident(std::unique_ptr<ResidentSpes> spes, Capacity capacity)
    : spes_(std::move(spes)), capacity_(std::move(capacity)) {}

void Resident::apply_remove(std::span<const Slot> places) {
  for (const Slot place : places) removed_.push_back(record_of(place, boxes_[place]));
}

// No SPU hears of a body that is where it was.
void Resident::apply_move(std::span<const Slot> places, std::span<const Aabb> boxes) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (boxes_[places[i]] == boxes[i]) continue;
    boxes_[places[i]] = boxes[i];
    moved_.push_back(record_of(places[i], boxes[i]));
  }
}

void Resident::apply_insert(std::span<const Slot> places, std::span<const Aabb> boxes) {
  boxes_.resize(place_count());
  for (std::size_t i = 0; i < places.size(); ++i) {
    boxes_[places[i]] = boxes[i];
    inserted_.push_back(record_of(places[i], boxes[i]));
  }
}

Result<FoundPairs> Resident::find_pairs(Statistics& statistics) {
  PhaseTimer timer(statistics.phases);
  if (Status status = tell_changes(); !status.ok()) return status;
  timer.lap("spus", PhaseKind::spes);
  const FoundPairs found = tracker_.commit();
  timer.lap("collect changes");
  refresh(statistics);
  return found;
}

// A body that is gone ends its pairs under its own name, though another has its place already.
Status Resident::tell_changes() {
  if (!spes_->failure().ok()) return spes_->failure();
  if (Status status = send(ResidentOrder::remove, removed_); !status.ok()) return status;
  if (Status status = send(ResidentOrder::move, moved_); !status.ok()) return status;
  names_.resize(place_count());
  for (const ResidentRecord& record : inserted_) names_[record.slot] = slot(record.slot);
  if (Status status = send(ResidentOrder::insert, inserted_); !status.ok()) return status;
  removed_.clear();
  moved_.clear();
  inserted_.clear();
  return {};
}

// An order that is too long becomes several: each leaves pairs right, so that the last one leaves them right
// for all.
Status Resident::send(ResidentOrder order, std::span<const ResidentRecord> records) {
  while (!records.empty()) {
    const std::size_t now = std::min(records.size(), spes_->records().size());
    std::copy_n(records.begin(), now, spes_->records().begin());
    if (Status status = spes_->obey(order, static_cast<std::uint32_t>(now)); !status.ok()) return status;
    note_events();
    bodies_sent_ += now;
    records = records.subspan(now);
  }
  return {};
}

void Resident::note_events() {
  for (unsigned spu = 0; spu < spes_->size(); ++spu) {
    for (const std::uint32_t event : spes_->events(spu)) {
      const Slot one = names_[(event >> kResidentSlotBits) & kPlaceMask];
      const Slot other = names_[event & kPlaceMask];
      tracker_.note(make_slot_pair(one, other), (event & kResidentBegan) != 0);
    }
    events_ += spes_->events(spu).size();
  }
}

// Poses beyond one order's room go with the next.
Status Resident::make_boxes(std::span<const BodyPose> poses, std::span<Aabb> boxes) {
  const std::size_t room = kLanes * spes_->poses().size();
  for (std::size_t done = 0; done < poses.size();) {
    const std::size_t now = std::min(poses.size() - done, room);
    pack(poses.subspan(done, now), spes_->poses());
    const auto count = static_cast<std::uint32_t>(now);
    if (Status status = spes_->obey(ResidentOrder::bound, count); !status.ok()) return status;
    take_boxes(boxes.subspan(done, now));
    done += now;
  }
  poses_sent_ += poses.size();
  return {};
}

void Resident::take_boxes(std::span<Aabb> boxes) const {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (unsigned axis = 0; axis < kAxes; ++axis) {
      const IntervalBlock& four = spes_->intervals(axis)[i / kLanes];
      boxes[i].min[axis] = four.low[i % kLanes];
      boxes[i].max[axis] = four.high[i % kLanes];
    }
  }
}

void Resident::refresh(Statistics& statistics) {
  cell_statistics_ = spes_->take_statistics();
  statistics.counters = {{"programs started", spes_->starts()},
                         {"mailbox words", spes_->mailbox_words()},
                         {"bodies sent", bodies_sent_},
                         {"poses sent", poses_sent_},
                         {"events", events_}};
  add_counters(cell_statistics_, statistics.counters);
  statistics.bytes += boxes_.capacity() * sizeof(Aabb);
}

}  // namespace cellsweep::cell
