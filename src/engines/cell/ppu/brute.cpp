#include "engines/cell/ppu/brute.h"

#include <algorithm>
#include <bit>

#include "base/text.h"
#include "cellsweep/engine/phase_timer.h"
#include "engines/cell/ppu/spe_counts.h"
#include "engines/cell/spu_programs.h"

namespace cellsweep::cell {
namespace {

constexpr std::uint64_t kMostBodies = 32768;
constexpr std::size_t kArrays = 6;
constexpr std::uint32_t kLargestNegative = 0xff7fffff;

/// An empty place: above and below everything at once, so that it overlaps nothing.
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

Status check(const CellBruteOptions& options) {
  if (options.spus <= kMostSpus) return {};
  return Status::bad_option("spus",
                            text("spus is ", options.spus, "; cell-brute uses at most ", kMostSpus, "."),
                            options.spus, kMostSpus);
}

Result<std::unique_ptr<Engine>> Brute::make(const CellBruteOptions& options,
                                            std::shared_ptr<Emulation> emulation) {
  if (Status status = check(options); !status.ok()) return status;
  auto capacity =
      local_store_capacity("cell-brute", emulation->local_store(), brute_buffers, kMostBodies,
                           text("the host's table of overlaps is made for ", kMostBodies, " bodies"));
  if (!capacity) return capacity.status();
  const unsigned spus = options.spus == 0 ? kDefaultSpus : options.spus;
  auto spes = SpeGroup::make(spus, cell_brute_spu, std::move(emulation));
  if (!spes) return spes.status();
  return std::unique_ptr<Engine>(new Brute(std::move(*spes), std::move(*capacity)));
}

Brute::Brute(std::unique_ptr<SpeGroup> spes, Capacity capacity)
    : spes_(std::move(spes)),
      capacity_(std::move(capacity)),
      shares_(spes_->size()),
      rows_(spes_->size()),
      jobs_(spes_->size()) {}

// Grows by doubling, for the arrays are copied.
void Brute::make_room() {
  const auto places = static_cast<std::uint32_t>(place_count());
  if (places <= stride_) return;
  const auto most = round_up(static_cast<std::uint32_t>(capacity_.bodies), kBruteBlock);
  const std::uint32_t stride = std::min(most, round_up(std::max(places, 2 * stride_), kBruteBlock));
  DmaVector<float> boxes(kArrays * stride);
  for (std::size_t array = 0; array < kArrays; ++array) {
    const Aabb& none = nowhere();
    const auto target = boxes.begin() + static_cast<std::ptrdiff_t>(array * stride);
    std::fill_n(target, stride, array < 3 ? none.min[array] : none.max[array - 3]);
    std::copy_n(boxes_.begin() + static_cast<std::ptrdiff_t>(array * stride_), stride_, target);
  }
  boxes_.swap(boxes);
  stride_ = stride;
  overlaps_.grow(stride);
}

void Brute::set_box(Slot place, const Aabb& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    boxes_[axis * stride_ + place] = box.min[axis];
    boxes_[(axis + 3) * stride_ + place] = box.max[axis];
  }
}

void Brute::apply_remove(std::span<const Slot> places) {
  for (const Slot place : places) {
    set_box(place, nowhere());
    overlaps_.clear(place, [&](Slot other) { tracker_.note(slots(place, other), false); });
  }
}

void Brute::apply_move(std::span<const Slot> places, std::span<const Aabb> boxes) {
  for (std::size_t i = 0; i < places.size(); ++i) set_box(places[i], boxes[i]);
  changed_.insert(changed_.end(), places.begin(), places.end());
}

void Brute::apply_insert(std::span<const Slot> places, std::span<const Aabb> boxes) {
  make_room();
  apply_move(places, boxes);
}

Result<FoundPairs> Brute::find_pairs(Statistics& statistics) {
  PhaseTimer timer(statistics.phases);
  const std::vector<void*> jobs = prepare_jobs();
  timer.lap("share out");
  if (Status status = spes_->run(jobs); !status.ok()) return status;
  timer.lap("spus", PhaseKind::spes);
  note_rows();
  const FoundPairs found = tracker_.commit();
  timer.lap("collect changes");
  refresh(statistics);
  return found;
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
  const std::size_t spus = std::min<std::size_t>(spes_->size(), changed_.size());
  for (std::size_t i = 0; i < changed_.size(); ++i) {
    const Slot place = changed_[i];
    const std::span<const std::uint32_t> rows = rows_[i % spus];
    overlaps_.replace_row(place, rows.subspan(i / spus * row_words, row_words),
                          [&](Slot other, bool now) { tracker_.note(slots(place, other), now); });
  }
  changed_.clear();
}

void Brute::refresh(Statistics& statistics) {
  cell_statistics_ = spes_->take_statistics();
  statistics.counters = {{"bodies tested", tested_}};
  add_counters(cell_statistics_, statistics.counters);
  statistics.bytes += overlaps_.bytes() + boxes_.capacity() * sizeof(float);
}

}  // namespace cellsweep::cell
