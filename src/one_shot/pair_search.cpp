#include "one_shot/pair_search.h"

#include <algorithm>
#include <utility>

#include "base/tuning.h"
#include "cellsweep/engine/piece_finder.h"
#include "engines/stream/search/sweep.h"

namespace cellsweep::one_shot {

using stream::CellBoxes;
using stream::TaggedBox;

/// Takes cells for later instead of finding their pairs.
class PairSearch::Collector final : public stream::PieceFinder {
 public:
  explicit Collector(std::vector<std::span<const CellBoxes>>& cells) : cells_(cells) {}

  void begin_update() override {}
  void find(std::span<const CellBoxes> cells, stream::KeyBuffer&) override { cells_.push_back(cells); }
  void add_counters(std::vector<Counter>&) const override {}

 private:
  std::vector<std::span<const CellBoxes>>& cells_;
};

PairSearch::PairSearch(Crew& crew, const stream::Kernels& kernels, const SearchedBoxes& boxes)
    : crew_(crew), kernels_(kernels), cross_(find_cross_kernel(kernels.isa)), boxes_(boxes) {
  const std::size_t all = boxes.boxes.size();
  const std::size_t first = boxes.second;
  const std::size_t fewer = std::min(first, all - first);
  crew_.use(1);
  if (boxes.are_two ? fewer == 0 : all == 0) return;
  if (boxes.are_two && fewer <= tuning::kMostPieced) {
    make_pieces();
  } else if (!boxes.are_two && all <= tuning::kOneCell) {
    make_one_cell();
  } else if (!sweep()) {
    make_tree();
  }
}

PairSearch::~PairSearch() = default;

// False when cells take less, or so many pairs overlap that it would be a pity to have all of them in memory
// before the first one is handed on. Of two sets, filters leave out the pairs within each.
bool PairSearch::sweep() {
  const std::size_t many = std::max(tuning::kMostSweptAtOnce / crew_.workers(), tuning::kMostSwept);
  const std::size_t most = boxes_.are_two ? tuning::kMostSwept : many;
  if (kernels_.sweep == nullptr || boxes_.boxes.size() > most) return false;
  if (boxes_.are_two) {
    constexpr BodyFilter kFirst{.category = 1, .mask = 2};
    constexpr BodyFilter kSecond{.category = 2, .mask = 1};
    sets_.renew(boxes_.boxes.size());
    std::fill_n(sets_.data(), boxes_.second, kFirst);
    std::fill(sets_.data() + boxes_.second, sets_.data() + sets_.size(), kSecond);
    swept_.allow(std::as_const(sets_).view());
  }
  swept_.buffer().most = tuning::kPairsSweptAtOnce * boxes_.boxes.size();
  try {
    return stream::Sweep().find(kernels_, boxes_.boxes, swept_);
  } catch (const stream::TooManyPairs&) {
    swept_.give_back();
    return false;
  }
}

// Room for so many cells with so many boxes in all.
CellBoxes* PairSearch::add_cells(std::size_t cells, std::size_t boxes) {
  made_.renew(cells);
  tagged_.renew(boxes + cells * stream::kMaxLanes);
  cells_.push_back(std::as_const(made_).view());
  return made_.data();
}

void PairSearch::make_one_cell() {
  const stream::Boxes boxes(boxes_.boxes.data(), boxes_.boxes.size());
  const auto count = static_cast<std::uint32_t>(boxes.count());
  CellBoxes& cell = *add_cells(1, count);
  cell = {tagged_.data(), count, count + stream::kMaxLanes};
  for (std::uint32_t slot = 0; slot < count; ++slot) tagged_.data()[slot] = {boxes[slot], boxes.tag(slot), 0};
}

// All of the smaller set against a few of the larger one at a time.
void PairSearch::make_pieces() {
  const stream::Boxes boxes(boxes_.boxes.data(), boxes_.boxes.size());
  const auto all = static_cast<std::uint32_t>(boxes.count());
  const std::uint32_t second = boxes_.second;
  const bool first_is_smaller = second <= all - second;
  const Share smaller = first_is_smaller ? Share{0, second} : Share{second, all};
  const Share larger = first_is_smaller ? Share{second, all} : Share{0, second};
  const std::size_t few = smaller.last - smaller.first;
  const std::size_t many = larger.last - larger.first;
  const std::size_t pieces = (many + tuning::kPieced - 1) / tuning::kPieced;
  CellBoxes* const cells = add_cells(pieces, many + pieces * few);
  TaggedBox* to = tagged_.data();
  const auto add = [&](std::size_t slot) { *to++ = {boxes[slot], boxes.tag(slot), 0}; };
  crew_.plan(all, tuning::kCrossTestGuess * static_cast<double>(few));
  for (std::size_t piece = 0; piece < pieces; ++piece) {
    const Share share = Share::of(many, static_cast<unsigned>(piece), static_cast<unsigned>(pieces));
    const auto count = static_cast<std::uint32_t>(few + share.last - share.first);
    cells[piece] = {to, count, count + stream::kMaxLanes};
    for (std::size_t i = smaller.first; i < smaller.last; ++i) add(i);
    for (std::size_t i = share.first; i < share.last; ++i) add(larger.first + i);
    to += stream::kMaxLanes;
  }
}

void PairSearch::make_tree() {
  started_ = WorkCost::Clock::now();
  crew_.plan(boxes_.boxes.size(), crew_.cost_of_new(boxes_.boxes.size()));
  collector_ = std::make_unique<Collector>(cells_);
  tree_ = std::make_unique<stream::CellTree>(crew_, kernels_, collector_.get());
  tree_->build({boxes_.boxes.data(), boxes_.boxes.size()});
}

void PairSearch::find_in(const CellBoxes& cell, Outlet& outlet) const {
  if (!boxes_.are_two) return kernels_.all_pairs(cell, cell.count, outlet);
  if (cell.count == 0) return;
  const auto is_of_first = [&](const TaggedBox& box) { return (box.tag & kSlotMask) < boxes_.second; };
  const bool one = is_of_first(cell.boxes[0]);
  // Those of one set lie together already, mostly: nothing has to be moved.
  const TaggedBox* const others = std::partition(
      cell.boxes, cell.boxes + cell.count, [&](const TaggedBox& box) { return is_of_first(box) == one; });
  cross_(cell, static_cast<std::uint32_t>(others - cell.boxes), outlet);
}

void PairSearch::find(std::span<const std::unique_ptr<Outlet>> outlets) {
  if (outlets.size() == 1) {
    outlets[0]->write(swept_.view());
    for (const auto cells : cells_) {
      for (const CellBoxes& cell : cells) find_in(cell, *outlets[0]);
    }
    outlets[0]->flush();
    return note_time();
  }
  constexpr std::size_t kRun = 64;
  std::vector<std::span<const CellBoxes>> runs;
  for (auto cells : cells_) {
    for (; !cells.empty(); cells = cells.subspan(std::min(kRun, cells.size())))
      runs.push_back(cells.first(std::min(kRun, cells.size())));
  }
  crew_.for_each(runs.size(), 1, [&](unsigned worker, std::size_t run) {
    for (const CellBoxes& cell : runs[run]) find_in(cell, *outlets[worker]);
  });
  for (const auto& outlet : outlets) outlet->flush();
  note_time();
}

// Of cells alone: other ways are not chosen where many workers would have much to do.
void PairSearch::note_time() {
  const std::size_t boxes = boxes_.boxes.size();
  if (tree_) crew_.cost_of_new(boxes).learn(WorkCost::Clock::now() - started_, crew_.active(), boxes);
}

void PairSearch::find(Outlet& outlet) {
  outlet.write(swept_.view());
  outlet.flush();
  for (const auto cells : cells_) {
    for (const CellBoxes& cell : cells) {
      find_in(cell, outlet);
      outlet.flush();
    }
  }
}

}  // namespace cellsweep::one_shot
