#include "engines/stream/cells/tree_build.h"

#include <algorithm>
#include <utility>

#include "base/tuning.h"

namespace cellsweep::stream {
namespace {

using tuning::kDeepest;
using tuning::kLargestCell;

/// Turns each worker's counts into their prefix sums, the places where it begins to write, and says how much
/// a cell gets in all.
void prefix_sums(std::uint32_t* counts, unsigned workers, std::uint32_t cells, std::uint32_t* sums) {
  for (std::uint32_t cell = 0; cell < cells; ++cell) {
    std::uint32_t sum = 0;
    for (unsigned worker = 0; worker < workers; ++worker) {
      std::uint32_t& place = counts[std::size_t{worker} * cells + cell];
      const std::uint32_t here = place;
      place = sum;
      sum += here;
    }
    sums[cell] = sum;
  }
}

constexpr Look kLooks[] = {Look::at_few, Look::at_all, Look::at_all_carefully};

std::size_t count_copies(std::span<const std::span<const BoxCopy>> lists) {
  std::size_t sum = 0;
  for (const auto list : lists) sum += list.size();
  return sum;
}

/// A list in an arena that nobody else takes from in the meantime. It moves when it outgrows its place.
template <class T>
class CopyList {
 public:
  CopyList(Arena& arena, std::size_t expected) : arena_(arena), capacity_(2 * expected + 64) {
    list_ = arena_.take<T>(capacity_);
  }

  /// Where to write the next `count`.
  T* room(std::size_t count) {
    if (size_ + count > capacity_) grow(count);
    return list_ + size_;
  }
  void added(std::size_t count) { size_ += count; }
  std::span<const T> view() const { return {list_, size_}; }

 private:
  void grow(std::size_t count) {
    capacity_ = 2 * capacity_ + count;
    T* larger = arena_.take<T>(capacity_);
    std::copy_n(list_, size_, larger);
    list_ = larger;
  }

  Arena& arena_;
  T* list_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_;
};

}  // namespace

CellBoxes new_cell(Arena& arena, std::size_t count, unsigned lanes) {
  const std::size_t unit = std::min(lanes, kBoxesTogether);
  CellBoxes cell;
  cell.capacity =
      static_cast<std::uint32_t>((count + count / tuning::kBoxesOfSpare + unit - 1) / unit * unit);
  cell.boxes = arena.take<TaggedBox>(cell.capacity);
  return cell;
}

Placement TreeBuilder::place(const Boxes& boxes, Node& root) {
  for (const Look look : kLooks) {
    if (auto placement = try_place(boxes, look, choose_grid(boxes, look), root)) return std::move(*placement);
  }
  return std::move(*try_place(boxes, Look::at_all, GridChoice{}, root));
}

// Nothing when boxes reach into many more cells than was expected, or the choice is doubtful.
std::optional<Placement> TreeBuilder::try_place(const Boxes& boxes, Look look, GridChoice choice,
                                                Node& root) {
  if (!choice.pays) {
    if (is_doubtful(look, boxes.count(), boxes.count())) return std::nullopt;
    choice.grid = Grid();
  }
  root.grid = choice.grid;
  const std::uint32_t cells = root.grid.cells();
  const unsigned workers = crew_.active();
  Scratch& scratch = *scratches_[0];
  auto* counts = scratch.job.take<std::uint32_t>(std::size_t{workers} * cells);
  auto* sums = scratch.job.take<std::uint32_t>(cells);
  std::fill_n(counts, std::size_t{workers} * cells, 0);
  std::vector<std::optional<std::span<const BoxCopy>>> copies(workers);
  crew_.run([&](unsigned worker) {
    const Share share = Share::of(boxes.count(), worker, workers);
    const std::size_t most =
        choice.most_copies(look == Look::at_few ? share.last - share.first : boxes.count());
    copies[worker] = list_copies(boxes, share, choice.grid, most, counts + std::size_t{worker} * cells,
                                 scratches_[worker]->job);
  });
  Placement placement;
  for (unsigned worker = 0; worker < workers; ++worker) {
    if (!copies[worker]) return std::nullopt;
    placement.copies.push_back(*copies[worker]);
    placement.places.push_back(counts + std::size_t{worker} * cells);
  }
  prefix_sums(counts, workers, cells, sums);
  if (is_doubtful(look, boxes.count(), *std::max_element(sums, sums + cells))) return std::nullopt;
  const std::size_t all_copies = count_copies(placement.copies);
  if (all_copies > choice.most_copies(boxes.count())) return std::nullopt;
  placement.inside = Level().inside(all_copies, boxes.count());
  placement.cells = make_targets(sums, cells, scratch);
  root.cells = scratch.cells.take<Cell>(cells);
  return placement;
}

void TreeBuilder::fill(const Boxes& boxes, const Placement& placement, double from, double to) {
  crew_.for_each(placement.copies.size(), 1, [&](unsigned, std::size_t list) {
    const std::span<const BoxCopy> copies = placement.copies[list];
    const auto place_of = [&](double share) {
      return static_cast<std::size_t>(share * static_cast<double>(copies.size()));
    };
    fill(boxes, copies.subspan(place_of(from), place_of(to) - place_of(from)), placement.cells,
         placement.places[list]);
  });
}

void TreeBuilder::finish(const Placement& placement, std::uint32_t first, std::uint32_t end, Node& root) {
  crew_.for_each(end - first, 4, [&](unsigned worker, std::size_t cell) {
    finish_cell(placement.cells[first + cell], root.cells[first + cell], *scratches_[worker],
                placement.inside);
  });
}

// Eight boxes from `first` on; behind the end there is nobody.
void TreeBuilder::find_blocks(const Boxes& boxes, std::size_t first, std::size_t end, const GridNumbers& grid,
                              EightBlocks& blocks) const {
  if (end - first >= 8) return kernels_.eight_blocks(&boxes[first], boxes.step(), grid, blocks);
  Aabb last[8];
  std::fill_n(last, 8, kNobody);
  for (std::size_t i = first; i < end; ++i) last[i - first] = boxes[i];
  kernels_.eight_blocks(last, sizeof(Aabb), grid, blocks);
}

// Which box goes into which cells, and how many come into each; nothing when these are too many. Whether a
// box reaches into one cell or two is as good as random: no branch asks for it.
std::optional<std::span<const BoxCopy>> TreeBuilder::list_copies(const Boxes& boxes, Share share,
                                                                 const Grid& grid, std::size_t most,
                                                                 std::uint32_t* counts, Arena& arena) const {
  CopyList<BoxCopy> list(arena, share.last - share.first);
  const GridNumbers numbers = grid.numbers();
  EightBlocks blocks;
  for (std::size_t i = share.first; i < share.last; ++i) {
    const std::size_t lane = (i - share.first) % 8;
    if (lane == 0) find_blocks(boxes, i, share.last, numbers, blocks);
    const auto index = static_cast<std::uint32_t>(i);
    if (const std::uint32_t more = blocks.more[lane]; more <= 1) {
      BoxCopy* to = list.room(2);
      to[0] = {index, blocks.first[lane]};
      to[1] = {index, blocks.second[lane]};
      ++counts[blocks.first[lane] & kSlotMask];
      counts[blocks.second[lane] & kSlotMask] += more;
      list.added(1 + more);
    } else if (more != EightBlocks::kNobody) {
      const CellBlock block = grid.block_of(boxes[i]);
      if (list.view().size() + block.cells() > most) return std::nullopt;
      BoxCopy* to = list.room(block.cells());
      grid.for_each_cell(block, [&](std::uint32_t cell, std::uint32_t flags) {
        *to++ = {index, cell | flags << kSlotBits};
        ++counts[cell];
      });
      list.added(block.cells());
    }
  }
  return list.view();
}

// Places are anywhere in memory: that of a copy further on is asked for meanwhile.
void TreeBuilder::fill(const Boxes& boxes, std::span<const BoxCopy> copies, const CellBoxes* targets,
                       std::uint32_t* places) const {
  const auto place_of = [&](const BoxCopy& copy) {
    const std::uint32_t cell = copy.cell_and_flags & kSlotMask;
    return targets[cell].boxes + places[cell];
  };
  for (std::size_t i = 0; i < copies.size(); ++i) {
    __builtin_prefetch(place_of(copies[std::min(i + tuning::kCopiesAhead, copies.size() - 1)]), 1);
    const BoxCopy copy = copies[i];
    const std::uint32_t tag = boxes.tag(copy.box) & (copy.cell_and_flags | kSlotMask);
    *place_of(copy) = {boxes[copy.box], tag, 0};
    ++places[copy.cell_and_flags & kSlotMask];
  }
}

// Where the boxes of each cell are to be put: for good, or for as long as it takes to cut the cell again.
CellBoxes* TreeBuilder::make_targets(const std::uint32_t* counts, std::uint32_t cells,
                                     Scratch& scratch) const {
  auto* targets = scratch.job.take<CellBoxes>(cells);
  std::size_t crowded = 0;
  for (std::uint32_t i = 0; i < cells; ++i) crowded += counts[i] > kLargestCell ? counts[i] : 0;
  auto* boxes = scratch.job.take<TaggedBox>(crowded);
  for (std::uint32_t i = 0; i < cells; ++i) {
    targets[i] = CellBoxes{};
    if (counts[i] > kLargestCell) {
      targets[i].boxes = boxes;
      boxes += counts[i];
    } else if (counts[i] > 0) {
      targets[i] = new_cell(scratch.cells, counts[i], kernels_.lanes);
    }
    targets[i].count = counts[i];
    scratch.copies += counts[i];
  }
  return targets;
}

void TreeBuilder::finish_cell(const CellBoxes& target, Cell& cell, Scratch& scratch,
                              const Level& level) const {
  if (target.count > kLargestCell) return build_inside(target, cell, scratch, level);
  cell = Cell{target, nullptr};
  find_pairs(target, scratch);
}

void TreeBuilder::find_pairs(const CellBoxes& cell, Scratch& scratch) const {
  if (collects_) {
    scratch.collected.push_back(cell);
  } else {
    // What is static is not compared with what is, too.
    const std::uint32_t rows = filters_.empty() ? cell.count : put_static_last(cell);
    kernels_.all_pairs(cell, rows, scratch.found.buffer());
    scratch.found.leave_out();
    scratch.tests += std::uint64_t{rows} * (2 * std::uint64_t{cell.count} - rows - 1) / 2;
  }
}

// Returns how many are not.
std::uint32_t TreeBuilder::put_static_last(const CellBoxes& cell) const {
  const auto moves = [&](const TaggedBox& box) {
    return !filter_of(filters_, box.tag & kSlotMask).is_static;
  };
  return static_cast<std::uint32_t>(std::partition(cell.boxes, cell.boxes + cell.count, moves) - cell.boxes);
}

void TreeBuilder::build_inside(const CellBoxes& boxes, Cell& cell, Scratch& scratch,
                               const Level& level) const {
  for (const Look look : kLooks) {
    if (level.depth >= kDeepest) break;
    const GridChoice choice = choose_grid(Boxes(boxes), look, level.most_copies);
    if (choice.pays) {
      if (split(Boxes(boxes), look, choice, cell, scratch, level)) return;
    } else if (!is_doubtful(look, boxes.count, boxes.count)) {
      break;
    }
  }
  keep_whole(boxes, cell, scratch);
}

// False when boxes reach into many more cells than was expected, or the choice is doubtful.
bool TreeBuilder::split(const Boxes& boxes, Look look, const GridChoice& choice, Cell& cell, Scratch& scratch,
                        const Level& level) const {
  const ArenaScope scope(scratch.job);
  const std::uint32_t cells = choice.grid.cells();
  auto* counts = scratch.job.take<std::uint32_t>(cells);
  std::fill_n(counts, cells, 0);
  const auto copies = list_copies(boxes, {0, boxes.count()}, choice.grid, choice.most_copies(boxes.count()),
                                  counts, scratch.job);
  if (!copies || is_doubtful(look, boxes.count(), *std::max_element(counts, counts + cells))) return false;
  scratch.copies -= boxes.count();
  const Level inside_level = level.inside(copies->size(), boxes.count());
  const CellBoxes* targets = make_targets(counts, cells, scratch);
  std::fill_n(counts, cells, 0);
  fill(boxes, *copies, targets, counts);
  Cell* const inside = scratch.cells.take<Cell>(cells);
  cell.boxes = CellBoxes{};
  cell.node = scratch.cells.take<Node>(1);
  *cell.node = Node{choice.grid, inside};
  for (std::uint32_t i = 0; i < cells; ++i) finish_cell(targets[i], inside[i], scratch, inside_level);
  return true;
}

void TreeBuilder::keep_whole(const CellBoxes& boxes, Cell& cell, Scratch& scratch) const {
  cell = Cell{new_cell(scratch.cells, boxes.count, kernels_.lanes), nullptr};
  cell.boxes.count = boxes.count;
  std::copy_n(boxes.boxes, boxes.count, cell.boxes.boxes);
  find_pairs(cell.boxes, scratch);
}

}  // namespace cellsweep::stream
