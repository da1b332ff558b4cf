#include "engines/cell/ppu/stream_spes.h"

#include <algorithm>

#include "base/text.h"
#include "cellsweep/engine/engine.h"
#include "engines/cell/ppu/layout.h"
#include "engines/cell/ppu/spe_counts.h"
#include "engines/cell/spu_programs.h"

namespace cellsweep::cell {
namespace {

/// Pairs that an SPU may send before the host takes them.
constexpr std::uint32_t kRoom = 16 * kStreamPairs;
constexpr std::uint64_t kBlockBytes = std::uint64_t{4} * kStreamWords * kStreamBlock;

static_assert(kTagBits == kSlotBits);
static_assert(sizeof(stream::TaggedBox) == sizeof(float) * kStreamWords);

}  // namespace

std::vector<LocalStorePart> stream_buffers(std::uint64_t) {
  return {{"job and result", sizeof(StreamJob) + sizeof(StreamResult)},
          {"pieces", kStreamPieces * sizeof(StreamPiece)},
          {"two chunks of pairs", std::uint64_t{2} * kStreamPairs * 8},
          {"four blocks of boxes", 4 * kBlockBytes},
          {"a block by coordinate", std::uint64_t{4} * (kStreamTag + 1) * kStreamBlock}};
}

Status check(const CellStreamOptions& options) {
  if (options.spus <= kMostSpus) return {};
  return Status::bad_option("spus",
                            text("spus is ", options.spus, "; cell-stream uses at most ", kMostSpus, "."),
                            options.spus, kMostSpus);
}

Result<std::unique_ptr<stream::PieceFinder>> StreamSpes::make(const CellStreamOptions& options,
                                                              std::shared_ptr<Emulation> emulation) {
  if (Status status = check(options); !status.ok()) return status;
  const LocalStoreMap map = make_local_store_map("cell-stream", emulation->local_store(), stream_buffers, 1);
  if (!map.fits()) {
    return Status::over_capacity(text("A piece of cell-stream does not fit: ", describe(map), "."),
                                 map.used(), map.limit, "local_store");
  }
  const unsigned spus = options.spus == 0 ? kDefaultSpus : options.spus;
  auto spes = SpeGroup::make(spus, cell_stream_spu, std::move(emulation));
  if (!spes) return spes.status();
  return std::unique_ptr<stream::PieceFinder>(new StreamSpes(std::move(*spes)));
}

StreamSpes::StreamSpes(std::unique_ptr<SpeGroup> spes)
    : spes_(std::move(spes)),
      shares_(spes_->size()),
      jobs_(spes_->size()),
      results_(spes_->size()),
      milliseconds_(spes_->size()) {}

// Each block of a cell with itself and with those behind it.
void StreamSpes::share_out(std::span<const stream::CellBoxes> cells) {
  for (Share& share : shares_) {
    share.pieces.clear();
    share.done = share.rows_done = 0;
  }
  std::size_t next = 0;
  for (const stream::CellBoxes& cell : cells) {
    const auto count_from = [&](std::uint32_t first) { return std::min(cell.count - first, kStreamBlock); };
    if (cell.count < 2) continue;
    for (std::uint32_t first = 0; first < cell.count; first += kStreamBlock) {
      for (std::uint32_t second = first; second < cell.count; second += kStreamBlock) {
        shares_[next++ % shares_.size()].pieces.push_back(
            {wire_address(cell.boxes), first, count_from(first), second, count_from(second), {}});
      }
    }
  }
  pieces_ += next;
}

std::vector<void*> StreamSpes::prepare_jobs() {
  std::vector<void*> jobs;
  for (Share& share : shares_) {
    if (share.done == share.pieces.size()) continue;
    share.pairs.resize(std::size_t{2} * kRoom);
    StreamJob& job = jobs_[jobs.size()];
    job = {wire_address(&share.pieces[share.done]),
           wire_address(share.pairs.data()),
           wire_address(&results_[jobs.size()]),
           static_cast<std::uint32_t>(share.pieces.size() - share.done),
           share.rows_done,
           kRoom,
           {}};
    jobs.push_back(&job);
  }
  return jobs;
}

void StreamSpes::take_results(stream::KeyBuffer& found) {
  std::size_t next = 0;
  for (Share& share : shares_) {
    if (share.done == share.pieces.size()) continue;
    const StreamResult& result = results_[next++];
    share.done += result.pieces_done;
    share.rows_done = result.rows_done;
    stream::make_room(found, result.pairs);
    for (std::size_t i = 0; i < std::size_t{2} * result.pairs; i += 2) {
      if (share.pairs[i] == kNoStreamPair) continue;
      found.keys[found.size++] = pair_key(make_slot_pair(share.pairs[i], share.pairs[i + 1]));
    }
  }
}

void StreamSpes::begin_update() {
  std::fill(milliseconds_.begin(), milliseconds_.end(), 0);
  static_cast<void>(spes_->take_statistics());
  refresh_statistics();
}

void StreamSpes::find(std::span<const stream::CellBoxes> cells, stream::KeyBuffer& found) {
  share_out(cells);
  for (std::vector<void*> jobs = prepare_jobs(); !jobs.empty(); jobs = prepare_jobs()) {
    run(jobs);
    take_results(found);
  }
  refresh_statistics();
}

void StreamSpes::run(std::span<void* const> jobs) {
  if (Status status = spes_->run(jobs); !status.ok()) throw stream::PieceFailure{std::move(status)};
  for (unsigned i = 0; i < spes_->size(); ++i) milliseconds_[i] += spes_->cpu_milliseconds(i);
}

// There may be several runs in an update.
void StreamSpes::refresh_statistics() {
  cell_statistics_ = spes_->statistics();
  cell_statistics_.longest_spu_ms = *std::max_element(milliseconds_.begin(), milliseconds_.end());
}

void StreamSpes::add_counters(std::vector<Counter>& counters) const {
  counters.push_back({"pieces on spes", pieces_});
  cell::add_counters(cell_statistics_, counters);
}

}  // namespace cellsweep::cell
