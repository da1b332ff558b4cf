#include "engines/cell/ppu/brute.h"

#include <algorithm>
#include <bit>

#include "base/text.h"
#include "cellsweep/engine/phase_timer.h"

extern "C" spe_program_handle_t cell_brute_spu;

namespace cellsweep::cell {
namespace {

constexpr unsigned kDefaultSpus = 3;
constexpr unsigned kMostSpus = 16;
constexpr std::uint64_t kMostBodies = 32768;
constexpr std::size_t kArrays = 6;
constexpr std::uint32_t kLargestNegative = 0xff7fffff;

/// An empty slot: above and below everything at once, so that it overlaps nothing.
const Aabb& nowhere() {
  const auto above = std::bit_cast<float>(kPaddingValueBits);
  const auto below = std::bit_cast<float>(kLargestNegative);
  static const Aabb box{{above, above, above}, {below, below, below}};
  return box;
}

}  // namespace

std::vector<LocalStorePart> brute_buffers(std::uint64_t bodies) {
  const std::uint64_t room = (bodies + kBruteBlock - 1) / kBruteBlock * kBruteBlock;
  const std::uint64_t row = (room / 8 + kDmaAlign - 1) / kDmaAlign * kDmaAlign;
  return {{"job", sizeof(BruteJob)},
          {"boxes", room * sizeof(Aabb)},
          {"changed bodies", room * 4},
          {"two rows", 2 * row}};
}

Result<std::unique_ptr<Broadphase>> Brute::make(const EngineOptions& options,
                                                std::shared_ptr<Emulation> emulation) {
  const unsigned spus = options.spus == 0 ? kDefaultSpus : options.spus;
  if (spus > kMostSpus) {
    return Status{StatusCode::bad_option,
                  text("spus is ", spus, "; cell-brute uses at most ", kMostSpus, "."),
                  std::nullopt,
                  spus,
                  kMostSpus,
                  "spus"};
  }
  Capacity capacity =
      local_store_capacity("cell-brute", emulation->local_store(), brute_buffers, kMostBodies,
                           text("the host's table of overlaps is made for ", kMostBodies, " bodies"));
  auto spes = SpeGroup::make(spus, cell_brute_spu, std::move(emulation));
  if (!spes) return spes.status();
  return std::unique_ptr<Broadphase>(new Brute(std::move(*spes), std::move(capacity)));
}

Brute::Brute(std::unique_ptr<SpeGroup> spes, Capacity capacity)
    : spes_(std::move(spes)),
      capacity_(std::move(capacity)),
      shares_(spes_->size()),
      rows_(spes_->size()),
      jobs_(spes_->size()) {}

// Grows by doubling, for the arrays are copied.
void Brute::make_room() {
  const auto slots = static_cast<std::uint32_t>(bodies().slot_count());
  if (slots <= stride_) return;
  const auto most = round_up(static_cast<std::uint32_t>(capacity_.bodies), kBruteBlock);
  const std::uint32_t stride = std::min(most, round_up(std::max(slots, 2 * stride_), kBruteBlock));
  DmaVector<float> boxes(kArrays * stride);
  for (std::size_t array = 0; array < kArrays; ++array) {
    const Aabb& none = nowhere();
    const auto target = boxes.begin() + static_cast<std::ptrdiff_t>(array * stride);
    std::fill_n(target, stride, array < 3 ? none.min[array] : none.max[array - 3]);
    std::copy_n(boxes_.begin() + static_cast<std::ptrdiff_t>(array * stride_), stride_, target);
  }
  boxes_.swap(boxes);
  stride_ = stride;
  is_touched_.resize(stride);
  overlaps_.grow(stride);
}

void Brute::set_box(Slot slot, const Aabb& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    boxes_[axis * stride_ + slot] = box.min[axis];
    boxes_[(axis + 3) * stride_ + slot] = box.max[axis];
  }
  if (is_touched_[slot]) return;
  is_touched_[slot] = true;
  touched_.push_back(slot);
}

void Brute::apply_insert(std::span<const Slot> slots, std::span<const Aabb> boxes) {
  make_room();
  apply_move(slots, boxes);
}

void Brute::apply_move(std::span<const Slot> slots, std::span<const Aabb> boxes) {
  for (std::size_t i = 0; i < slots.size(); ++i) set_box(slots[i], boxes[i]);
}

void Brute::apply_remove(std::span<const Slot> slots) {
  for (const Slot slot : slots) {
    set_box(slot, nowhere());
    overlaps_.clear(
        slot, [&](Slot other) { tracker_.note(make_pair_of(bodies().id(slot), bodies().id(other)), false); });
  }
}

Result<PairChanges> Brute::update() {
  PhaseTimer timer(statistics_.phases);
  list_changed();
  const std::vector<void*> jobs = prepare_jobs();
  timer.lap("share out");
  if (Status status = spes_->run(jobs); !status.ok()) return status;
  timer.lap("spus");
  note_rows();
  const PairChanges changes = tracker_.commit();
  timer.lap("collect changes");
  ++statistics_.updates;
  refresh_counters();
  statistics_.cell = spes_->take_cell_time();
  return changes;
}

// Slots emptied since they were touched have no row: removing them has cleared it.
void Brute::list_changed() {
  changed_.clear();
  const float none = nowhere().min[0];
  for (const Slot slot : touched_) {
    if (boxes_[slot] != none) changed_.push_back(slot);
  }
}

// SPU k takes every so-manieth changed body; without any, nothing runs.
std::vector<void*> Brute::prepare_jobs() {
  std::vector<void*> jobs;
  const std::size_t spus = std::min<std::size_t>(spes_->size(), changed_.size());
  for (auto& share : shares_) share.clear();
  for (std::size_t i = 0; i < changed_.size(); ++i) shares_[i % spus].push_back(changed_[i]);
  for (std::size_t spu = 0; spu < spus; ++spu) {
    const auto count = static_cast<std::uint32_t>(shares_[spu].size());
    rows_[spu].resize(std::size_t{count} * stride_ / 32);
    jobs_[spu] = {wire_address(boxes_.data()),
                  wire_address(shares_[spu].data()),
                  wire_address(rows_[spu].data()),
                  stride_,
                  count,
                  {}};
    jobs.push_back(&jobs_[spu]);
  }
  tested_ += changed_.size();
  return jobs;
}

void Brute::note_rows() {
  const std::size_t row_words = stride_ / 32;
  for (std::size_t i = 0; i < changed_.size(); ++i) {
    const Slot slot = changed_[i];
    const std::size_t spus = std::min<std::size_t>(spes_->size(), changed_.size());
    const std::span<const std::uint32_t> rows = rows_[i % spus];
    overlaps_.replace_row(slot, rows.subspan(i / spus * row_words, row_words), [&](Slot other, bool now) {
      tracker_.note(make_pair_of(bodies().id(slot), bodies().id(other)), now);
    });
  }
  for (const Slot slot : touched_) is_touched_[slot] = false;
  touched_.clear();
}

void Brute::refresh_counters() {
  const SpeCounts counts = spes_->counts();
  statistics_.counters = {
      {"bodies tested", tested_},          {"dma gets", counts.gets},
      {"dma puts", counts.puts},           {"dma bytes in", counts.bytes_in},
      {"dma bytes out", counts.bytes_out}, {"local store high water", counts.local_store_high_water}};
}

}  // namespace cellsweep::cell
