#include "engines/stream/cells/tree_change.h"

#include <algorithm>
#include <array>

#include "base/memory/fetch.h"
#include "base/tuning.h"
#include "cellsweep/function_ref.h"
#include "engines/stream/cells/tree_build.h"

namespace cellsweep::stream {
namespace {

/// Stops what would put boxes into too many cells, or more than their places can be numbered.
void check_visits(std::uint64_t visits, const Scratch& scratch) {
  constexpr std::uint64_t kMostPlaces = ~std::uint32_t{0};
  if (visits > std::min(scratch.most_copies, kMostPlaces)) throw TooMuchWork();
}

/// The place of a body, which is not one of the first `from`.
std::uint32_t place_of(const CellBoxes& cell, std::uint32_t slot, std::uint32_t from) {
  while ((cell.boxes[from].tag & kSlotMask) != slot) ++from;
  return from;
}

/// So many cells that changes come into are a worker's.
constexpr std::size_t kCellsTogether = 16;

/// Cells that the same worker changes after the one of run `i` are asked for, which may be anywhere in
/// memory. What another one changes must not be looked at. In line for the reason that fetch() gives.
[[gnu::always_inline]] inline void fetch_ahead(std::span<const CellPlaces::Run> runs, std::size_t i,
                                               const Cell* cells) {
  const std::size_t end = std::min(i / kCellsTogether * kCellsTogether + kCellsTogether, runs.size());
  if (const std::size_t far = i + 2 * tuning::kCellsAhead; far < runs.size())
    __builtin_prefetch(&cells[runs[far].cell]);
  if (i + tuning::kCellsAhead >= end) return;
  const CellBoxes& cell = cells[runs[i + tuning::kCellsAhead].cell].boxes;
  fetch(cell.boxes, cell.count * sizeof(TaggedBox));
}

}  // namespace

TreeChanger::Visit TreeChanger::first_visit(const FatBoxChange& change, std::size_t index) {
  constexpr auto kWhole = static_cast<std::uint8_t>(kThere | kWholeFlags);
  return {static_cast<std::uint32_t>(index), change.was ? kWhole : std::uint8_t{0},
          change.is ? kWhole : std::uint8_t{0}};
}

TreeChanger::Blocks TreeChanger::blocks_of(const Visit& visit, const Grid& grid) const {
  const FatBoxChange& change = changes_[visit.change];
  return {visit.old_flags != 0 ? grid.block_of(change.old_box) : CellBlock{},
          visit.new_flags != 0 ? grid.block_of(change.new_box) : CellBlock{}};
}

// Comes, goes, or stays in the same cells.
bool TreeChanger::is_of_one_block(const Visit& visit, const Blocks& blocks) {
  return visit.old_flags == 0 || visit.new_flags == 0 || blocks.was == blocks.is;
}

void TreeChanger::count_visits(const Visit& visit, const Blocks& blocks, const Grid& grid,
                               CellPlaces::OfWorker places) {
  const CellBlock* block = visit.old_flags != 0 ? &blocks.was : &blocks.is;
  const CellBlock* const last = is_of_one_block(visit, blocks) ? block : &blocks.is;
  while (true) {
    grid.for_each_cell(*block, [&](std::uint32_t cell, std::uint32_t) { places.count(cell); });
    if (block == last) return;
    block = last;
  }
}

// Visits of the cells inside: of those it was in first, and then of those it is in now, unless they are the
// same.
template <class Emit>
void TreeChanger::for_each_visit(const Visit& visit, const Blocks& blocks, const Grid& grid, Emit&& emit) {
  const auto within = [](std::uint8_t flags, std::uint32_t inner) {
    return flags == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(flags & (kThere | inner));
  };
  if (is_of_one_block(visit, blocks)) {
    grid.for_each_cell(
        visit.old_flags != 0 ? blocks.was : blocks.is, [&](std::uint32_t cell, std::uint32_t inner) {
          emit(cell, Visit{visit.change, within(visit.old_flags, inner), within(visit.new_flags, inner)});
        });
    return;
  }
  grid.for_each_cell(blocks.was, [&](std::uint32_t cell, std::uint32_t inner) {
    emit(cell, Visit{visit.change, within(visit.old_flags, inner), 0});
  });
  grid.for_each_cell(blocks.is, [&](std::uint32_t cell, std::uint32_t inner) {
    emit(cell, Visit{visit.change, 0, within(visit.new_flags, inner)});
  });
}

void TreeChanger::put_visits(const Visit& visit, const Blocks& blocks, const Grid& grid,
                             CellPlaces::OfWorker places, Visit* to) {
  for_each_visit(visit, blocks, grid,
                 [&](std::uint32_t cell, const Visit& inside) { to[places.next(cell)] = inside; });
}

void TreeChanger::change(std::span<const FatBoxChange> changes, Node& root) {
  changes_ = changes;
  const unsigned workers = crew_.active();
  Arena& scratch = scratches_[0]->job;
  CellPlaces places(scratch, workers, root.grid.cells());
  auto* blocks = scratch.take<Blocks>(changes.size());
  const auto for_share = [&](unsigned worker, auto&& visit) {
    const Share share = Share::of(changes.size(), worker, workers);
    for (std::size_t i = share.first; i < share.last; ++i) visit(first_visit(changes[i], i), blocks[i]);
  };
  crew_.run([&](unsigned worker) {
    for_share(worker, [&, mine = places.of(worker)](const Visit& visit, Blocks& there) {
      there = blocks_of(visit, root.grid);
      count_visits(visit, there, root.grid, mine);
    });
  });
  const std::uint64_t count = places.lay_out();
  check_visits(count, *scratches_[0]);
  auto* visits = scratch.take<Visit>(count);
  crew_.run([&](unsigned worker) {
    for_share(worker, [&, mine = places.of(worker)](const Visit& visit, const Blocks& there) {
      put_visits(visit, there, root.grid, mine, visits);
    });
  });
  crew_.for_each(places.runs().size(), kCellsTogether, [&](unsigned worker, std::size_t i) {
    const CellPlaces::Run& run = places.runs()[i];
    fetch_ahead(places.runs(), i, root.cells);
    change_cell({visits + run.first, run.count}, root.cells[run.cell], *scratches_[worker]);
  });
}

// Says how many cells one body visits, and lists them unless the list is null. By a reference to a function,
// for the size of programs: the ways through a grid, with what is done at each place in them, would be 12 KB.
std::size_t TreeChanger::list_cells(const FatBoxChange& change, const Blocks& blocks, const Grid& grid,
                                    CellVisit* list) {
  std::size_t count = 0;
  const auto note = [&](std::uint32_t cell, const Visit& visit) {
    if (list != nullptr) list[count] = {cell, visit};
    ++count;
  };
  for_each_visit(first_visit(change, 0), blocks, grid, FunctionRef<void(std::uint32_t, const Visit&)>(note));
  return count;
}

void TreeChanger::change_one(const FatBoxChange& change, Node& root) {
  changes_ = {&change, 1};
  finds_pairs_ = false;
  Scratch& scratch = *scratches_[0];
  const Blocks blocks = blocks_of(first_visit(change, 0), root.grid);
  const std::size_t count = list_cells(change, blocks, root.grid, nullptr);
  check_visits(count, scratch);
  auto* visits = scratch.job.take<CellVisit>(count);
  const CellVisit* const end = visits + list_cells(change, blocks, root.grid, visits);
  // Ascending: the cells that it was in, and behind these, unless they are the same, those that it is in. Of
  // one that it stays in, the visit that takes it out comes first.
  const CellVisit* was = visits;
  const CellVisit* is = std::find_if(was, end, [](const CellVisit& visit) { return enters(visit.visit); });
  const CellVisit* const was_end = is;
  while (was != was_end || is != end) {
    const std::uint32_t cell = is == end || (was != was_end && was->cell < is->cell) ? was->cell : is->cell;
    std::array<Visit, 2> here;
    std::size_t visited = 0;
    if (was != was_end && was->cell == cell) here[visited++] = (was++)->visit;
    if (is != end && is->cell == cell) here[visited++] = (is++)->visit;
    change_cell({here.data(), visited}, root.cells[cell], scratch);
  }
}

// The two visits of a body that stays in a cell but not in all of its cells stand side by side.
std::span<TreeChanger::Visit> TreeChanger::merge(std::span<Visit> visits) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < visits.size(); ++i) {
    if (kept > 0 && visits[kept - 1].change == visits[i].change) {
      visits[kept - 1].new_flags = visits[i].new_flags;
    } else {
      visits[kept++] = visits[i];
    }
  }
  return visits.first(kept);
}

void TreeChanger::change_cell(std::span<Visit> visits, Cell& cell, Scratch& scratch) const {
  const std::span<Visit> merged = merge(visits);
  const ArenaScope scope(scratch.job);
  if (cell.node != nullptr) return change_node(merged, *cell.node, scratch);
  change_boxes(merged, cell.boxes, scratch);
}

void TreeChanger::change_node(std::span<const Visit> visits, Node& node, Scratch& scratch) const {
  CellPlaces places(scratch.job, 1, node.grid.cells());
  auto* blocks = scratch.job.take<Blocks>(visits.size());
  for (std::size_t i = 0; i < visits.size(); ++i) {
    blocks[i] = blocks_of(visits[i], node.grid);
    count_visits(visits[i], blocks[i], node.grid, places.of(0));
  }
  const std::uint64_t count = places.lay_out();
  check_visits(count, scratch);
  auto* inside = scratch.job.take<Visit>(count);
  for (std::size_t i = 0; i < visits.size(); ++i) {
    put_visits(visits[i], blocks[i], node.grid, places.of(0), inside);
  }
  for (const CellPlaces::Run& run : places.runs())
    change_cell({inside + run.first, run.count}, node.cells[run.cell], scratch);
}

void TreeChanger::make_room(CellBoxes& cell, std::uint32_t more, Scratch& scratch) const {
  scratch.copies += more;
  if (scratch.copies > scratch.most_copies) throw TooMuchWork();
  if (cell.count + more <= cell.capacity) return;
  CellBoxes larger = new_cell(scratch.cells, std::size_t{cell.count} + more, kernels_.lanes);
  larger.count = cell.count;
  std::copy_n(cell.boxes, cell.count, larger.boxes);
  cell = larger;
}

// What changed and is still there comes to stand first: these are the rows that are compared.
void TreeChanger::change_boxes(std::span<const Visit> visits, CellBoxes& cell, Scratch& scratch) const {
  make_room(cell, static_cast<std::uint32_t>(std::count_if(visits.begin(), visits.end(), enters)), scratch);
  TaggedBox* const boxes = cell.boxes;
  std::uint32_t rows = 0;
  for (const Visit& visit : visits) {
    const FatBoxChange& change = changes_[visit.change];
    const std::uint32_t place = enters(visit) ? cell.count++ : place_of(cell, change.slot, rows);
    if (visit.new_flags == 0) {
      boxes[place] = boxes[--cell.count];
      continue;
    }
    boxes[place] = boxes[rows];
    boxes[rows++] = {change.new_box, change.slot | std::uint32_t{visit.new_flags} % kThere << kSlotBits, 0};
  }
  if (!finds_pairs_) return;
  scratch.tests += std::uint64_t{rows} * (2 * std::uint64_t{cell.count} - rows - 1) / 2;
  if (scratch.tests > scratch.most_tests) throw TooMuchWork();
  kernels_.all_pairs(cell, rows, scratch.touched.buffer());
}

}  // namespace cellsweep::stream
