#include "engines/cell/ppu/paper.h"

#include <algorithm>

#include "base/text.h"
#include "cellsweep/engine/phase_timer.h"
#include "engines/cell/ppu/spe_counts.h"
#include "engines/cell/spu_programs.h"

namespace cellsweep::cell {
namespace {

std::uint64_t lines(std::uint64_t bytes) {
  return (bytes + kDmaAlign - 1) / kDmaAlign * kDmaAlign;
}

/// The smallest of three limits: keys, pair map, local store (C14).
Result<Capacity> find_capacity(const CellPaperOptions& options, const LocalStoreBudget& budget) {
  const std::uint64_t by_map = control::bodies_that_fit(options.pair_map_bytes);
  const bool keys_limit = by_map >= kLargestPaperId;
  auto capacity = local_store_capacity(
      "cell-paper", budget, [&](std::uint64_t bodies) { return paper_buffers(options, bodies); },
      std::min<std::uint64_t>(by_map, kLargestPaperId),
      keys_limit ? text("the document's pair key tells ", kLargestPaperId, " bodies apart")
                 : text("its map of all possible pairs, ", control::kPairMapEntryBytes,
                        " bytes each, is limited to ", options.pair_map_bytes, " bytes"));
  if (capacity && capacity->setting.empty() && !keys_limit) capacity->setting = "pair_map_bytes";
  return capacity;
}

std::uint32_t flags_of(const CellPaperOptions& options) {
  return (options.literal ? kPaperLiteral : 0U) | (options.method == 2 ? kPaperMethod2 : 0U) |
         (options.list_dma ? kPaperListDma : 0U);
}

}  // namespace

Status check(const CellPaperOptions& options) {
  if (options.method != 1 && options.method != 2) {
    return Status::bad_option("method", text("method is ", options.method, "; the document has 1 and 2."),
                              options.method, 2);
  }
  if (options.pair_map_bytes >= control::kPairMapEntryBytes) return {};
  return Status::bad_option("pair_map_bytes",
                            text("pair_map_bytes is ", options.pair_map_bytes, "; one pair takes ",
                                 control::kPairMapEntryBytes, " bytes, so at least that is needed."),
                            options.pair_map_bytes, control::kPairMapEntryBytes);
}

std::vector<LocalStorePart> paper_buffers(const CellPaperOptions& options, std::uint64_t bodies) {
  const std::uint64_t endpoints = lines((2 * bodies + kLanes - 1) / kLanes * kLanes * 4);
  const std::uint64_t stream = std::uint64_t{2} * (options.list_dma ? kListBytes + kDmaAlign : kChunkBytes);
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

Result<std::unique_ptr<Engine>> Paper::make(const CellPaperOptions& options,
                                            std::shared_ptr<Emulation> emulation) {
  if (Status status = check(options); !status.ok()) return status;
  auto capacity = find_capacity(options, emulation->local_store());
  if (!capacity) return capacity.status();
  auto spes = SpeGroup::make(kAxes, cell_paper_spu, std::move(emulation));
  if (!spes) return spes.status();
  return std::unique_ptr<Engine>(new Paper(options, std::move(*spes), std::move(*capacity)));
}

Paper::Paper(const CellPaperOptions& options, std::unique_ptr<SpeGroup> spes, Capacity capacity)
    : options_(options), spes_(std::move(spes)), capacity_(std::move(capacity)) {
  for (std::size_t axis = 0; axis < kAxes; ++axis) axes_.emplace_back(axis, flags_of(options));
}

void Paper::apply_remove(std::span<const Slot> places) {
  for (const Slot place : places) {
    in_use_[place] = false;
    pairs_.remove_body(place + 1, changed_pairs_);
  }
  for (control::PairInfo& pair : changed_pairs_) pair.value[0] = false;
  note_changed_pairs();
  rebuild_ = true;
}

void Paper::apply_move(std::span<const Slot> places, std::span<const Aabb> boxes) {
  for (std::size_t i = 0; i < places.size(); ++i) boxes_[places[i]] = boxes[i];
}

void Paper::apply_insert(std::span<const Slot> places, std::span<const Aabb> boxes) {
  boxes_.resize(place_count());
  in_use_.resize(place_count());
  for (const Slot place : places) in_use_[place] = true;
  new_places_.assign(places.begin(), places.end());
  rebuild_ = true;
  apply_move(places, boxes);
}

Result<FoundPairs> Paper::find_pairs(Statistics& statistics) {
  PhaseTimer timer(statistics.phases);
  enter_new_bodies();
  timer.lap("fill pair map", PhaseKind::setup);
  fill_arrays();
  timer.lap("refill values");
  if (Status status = run_spus(); !status.ok()) return status;
  timer.lap("spus", PhaseKind::spes);
  for (std::size_t axis = 0; axis < kAxes && !used_.empty(); ++axis) update_pairs(axis);
  pairs_.commit(changed_pairs_);
  timer.lap("update pairs");
  note_changed_pairs();
  const FoundPairs found = tracker_.commit();
  timer.lap("collect changes");
  refresh(statistics);
  return found;
}

// X1: every new body gets an entry with every other one.
void Paper::enter_new_bodies() {
  const SpeGroup::Aside aside(*spes_);  // set-up
  for (const Slot place : new_places_) pairs_.add_body(place + 1);
  new_places_.clear();
}

// C3, or C2 when bodies came or went. Listing 4.12's method 2 keeps reading the values of the first frame
// (C12).
void Paper::fill_arrays() {
  if (rebuild_) {
    used_.clear();
    for (Slot place = 0; place < in_use_.size(); ++place) {
      if (in_use_[place]) used_.push_back(place);
    }
  }
  for (PaperAxis& axis : axes_) {
    rebuild_ ? axis.rebuild(used_, boxes_) : axis.refill(boxes_);
    if (options_.method == 2 && (rebuild_ || !options_.literal)) axis.fill_body_values(used_, boxes_);
  }
}

// C1. Without bodies nothing runs.
Status Paper::run_spus() {
  std::vector<void*> jobs;
  for (PaperAxis& axis : axes_) {
    if (!used_.empty()) jobs.push_back(axis.make_job(rebuild_));
  }
  rebuild_ = false;
  return spes_->run(jobs);
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
    tracker_.note(slots(one, other), pair.colliding());
  }
  changed_pairs_.clear();
}

void Paper::refresh(Statistics& statistics) {
  cell_statistics_ = spes_->take_statistics();
  const auto longest = static_cast<std::uint64_t>(cell_statistics_.longest_spu_ms * 1e6);
  statistics.counters = {{"changed ids", changed_ids_},
                         {"keys", keys_},
                         {"pair map entries", pairs_.size()},
                         {"longest spu of this update, ns", longest},
                         {"dma list elements", cell_statistics_.dma_list_elements}};
  add_counters(cell_statistics_, statistics.counters);
  statistics.bytes += pairs_.bytes();
}

}  // namespace cellsweep::cell
