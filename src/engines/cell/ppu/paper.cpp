#include "engines/cell/ppu/paper.h"

#include <algorithm>

#include "base/text.h"
#include "cellsweep/engine/phase_timer.h"

extern "C" spe_program_handle_t cell_paper_spu;

namespace cellsweep::cell {
namespace {

constexpr unsigned kAxes = 3;

std::uint64_t lines(std::uint64_t bytes) {
  return (bytes + kDmaAlign - 1) / kDmaAlign * kDmaAlign;
}

Status check(const EngineOptions& options) {
  if (options.method != 1 && options.method != 2) {
    return {StatusCode::bad_option,
            text("method is ", options.method, "; the document has 1 and 2."),
            std::nullopt,
            options.method,
            2,
            "method"};
  }
  if (options.pair_map_bytes >= control::kPairMapEntryBytes) return {};
  return {StatusCode::bad_option,
          text("pair_map_bytes is ", options.pair_map_bytes, "; one pair takes ", control::kPairMapEntryBytes,
               " bytes, so at least that is needed."),
          std::nullopt,
          options.pair_map_bytes,
          control::kPairMapEntryBytes,
          "pair_map_bytes"};
}

/// The smallest of three limits: keys, pair map, local store (C14).
Capacity find_capacity(const EngineOptions& options, const LocalStoreBudget& budget) {
  const std::uint64_t by_map = control::bodies_that_fit(options.pair_map_bytes);
  const bool keys_limit = by_map >= kLargestPaperId;
  Capacity capacity = local_store_capacity(
      "cell-paper", budget, [&](std::uint64_t bodies) { return paper_buffers(options, bodies); },
      std::min<std::uint64_t>(by_map, kLargestPaperId),
      keys_limit ? text("the document's pair key tells ", kLargestPaperId, " bodies apart")
                 : text("its map of all possible pairs, ", control::kPairMapEntryBytes,
                        " bytes each, is limited to ", options.pair_map_bytes, " bytes"));
  if (capacity.setting.empty() && !keys_limit) capacity.setting = "pair_map_bytes";
  return capacity;
}

std::uint32_t flags_of(const EngineOptions& options) {
  return (options.literal ? kPaperLiteral : 0U) | (options.method == 2 ? kPaperMethod2 : 0U) |
         (options.list_dma ? kPaperListDma : 0U);
}

}  // namespace

std::vector<LocalStorePart> paper_buffers(const EngineOptions& options, std::uint64_t bodies) {
  const std::uint64_t endpoints = lines((2 * bodies + kLanes - 1) / kLanes * kLanes * 4);
  const std::uint64_t stream = 2 * (options.list_dma ? kListBytes + kDmaAlign : kChunkBytes);
  std::vector<LocalStorePart> parts = {{"job and result", sizeof(PaperJob) + sizeof(PaperResult)},
                                       {"values", endpoints},
                                       {"ids", endpoints},
                                       {"values before", endpoints},
                                       {"ids before, then changed ids", endpoints}};
  if (options.method == 2) {
    parts.push_back({"values by body", lines(2 * bodies * 4)});
    parts.push_back({"keys of pairs apart", stream});
  } else if (!options.literal) {
    parts.push_back({"places by id", lines((bodies + 1) * 8)});
  }
  parts.push_back({"keys", stream});
  return parts;
}

Result<std::unique_ptr<Broadphase>> Paper::make(const EngineOptions& options,
                                                std::shared_ptr<Emulation> emulation) {
  if (Status status = check(options); !status.ok()) return status;
  Capacity capacity = find_capacity(options, emulation->local_store());
  auto spes = SpeGroup::make(kAxes, cell_paper_spu, std::move(emulation));
  if (!spes) return spes.status();
  return std::unique_ptr<Broadphase>(new Paper(options, std::move(*spes), std::move(capacity)));
}

Paper::Paper(const EngineOptions& options, std::unique_ptr<SpeGroup> spes, Capacity capacity)
    : options_(options), spes_(std::move(spes)), capacity_(std::move(capacity)) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) axes_.emplace_back(axis, flags_of(options));
}

void Paper::apply_insert(std::span<const Slot> slots, std::span<const Aabb> boxes) {
  boxes_.resize(bodies().slot_count());
  in_use_.resize(bodies().slot_count());
  for (const Slot slot : slots) {
    in_use_[slot] = true;
    new_slots_.push_back(slot);
  }
  rebuild_ = true;
  apply_move(slots, boxes);
}

void Paper::apply_move(std::span<const Slot> slots, std::span<const Aabb> boxes) {
  for (std::size_t i = 0; i < slots.size(); ++i) boxes_[slots[i]] = boxes[i];
}

void Paper::apply_remove(std::span<const Slot> slots) {
  std::vector<bool> is_new(boxes_.size(), false);
  for (const Slot slot : new_slots_) is_new[slot] = true;
  for (const Slot slot : slots) {
    in_use_[slot] = false;
    if (!is_new[slot]) pairs_.remove_body(slot + 1, changed_pairs_);
  }
  std::erase_if(new_slots_, [&](Slot slot) { return !in_use_[slot]; });
  for (control::PairInfo& pair : changed_pairs_) pair.value[0] = false;
  note_changed_pairs();
  rebuild_ = true;
}

Result<PairChanges> Paper::update() {
  PhaseTimer timer(statistics_.phases);
  enter_new_bodies();
  timer.lap("fill pair map", true);
  fill_arrays();
  timer.lap("refill values");
  if (Status status = run_spus(); !status.ok()) return status;
  timer.lap("spus");
  for (std::size_t axis = 0; axis < kAxes && !slots_.empty(); ++axis) update_pairs(axis);
  pairs_.commit(changed_pairs_);
  timer.lap("update pairs");
  note_changed_pairs();
  const PairChanges changes = tracker_.commit();
  timer.lap("collect changes");
  ++statistics_.updates;
  refresh_counters();
  statistics_.cell = spes_->take_cell_time();
  return changes;
}

// X1: every new body gets an entry with every other one.
void Paper::enter_new_bodies() {
  const SpeGroup::Aside aside(*spes_);  // set-up
  for (const Slot slot : new_slots_) pairs_.add_body(slot + 1);
  new_slots_.clear();
}

// C3, or C2 when bodies came or went. Listing 4.12's method 2 keeps reading the values of the first frame
// (C12).
void Paper::fill_arrays() {
  if (rebuild_) {
    slots_.clear();
    for (Slot slot = 0; slot < in_use_.size(); ++slot) {
      if (in_use_[slot]) slots_.push_back(slot);
    }
  }
  for (PaperAxis& axis : axes_) {
    rebuild_ ? axis.rebuild(slots_, boxes_) : axis.refill(boxes_);
    if (options_.method == 2 && (rebuild_ || !options_.literal)) axis.fill_body_values(slots_, boxes_);
  }
}

// C1. A frame that fails leaves the arrays as they may be, so the next one begins anew.
Status Paper::run_spus() {
  if (slots_.empty()) {
    rebuild_ = false;
    return {};
  }
  std::vector<void*> jobs;
  for (PaperAxis& axis : axes_) jobs.push_back(axis.make_job(rebuild_));
  rebuild_ = true;
  if (Status status = spes_->run(jobs); !status.ok()) return status;
  rebuild_ = false;
  return {};
}

// C11, C12, C15.
void Paper::update_pairs(std::size_t axis) {
  const PaperAxis& from = axes_[axis];
  if (options_.method == 1) pairs_.clear_earlier(axis, from.changed());
  pairs_.apply(axis, from.keys(), true);
  pairs_.apply(axis, from.apart_keys(), false);
  changed_ids_ += from.changed().size();
  keys_ += from.keys().size() + from.apart_keys().size();
}

void Paper::note_changed_pairs() {
  for (const control::PairInfo& pair : changed_pairs_) {
    const auto one = static_cast<Slot>(pair.aID - 1);
    const auto other = static_cast<Slot>(pair.bID - 1);
    tracker_.note(make_pair_of(bodies().id(one), bodies().id(other)), pair.colliding());
  }
  changed_pairs_.clear();
}

void Paper::refresh_counters() {
  const SpeCounts counts = spes_->counts();
  const auto longest = static_cast<std::uint64_t>(spes_->longest_cpu_milliseconds() * 1e6);
  statistics_.counters = {{"changed ids", changed_ids_},
                          {"keys", keys_},
                          {"pair map entries", pairs_.size()},
                          {"longest spu of this update, ns", longest},
                          {"dma gets", counts.gets},
                          {"dma puts", counts.puts},
                          {"dma bytes in", counts.bytes_in},
                          {"dma bytes out", counts.bytes_out},
                          {"dma list elements", counts.list_elements},
                          {"local store high water", counts.local_store_high_water}};
}

}  // namespace cellsweep::cell
