#include "engines/stream/cells/cell_tree.h"

#include <algorithm>
#include <utility>

#include "base/tuning.h"
#include "cellsweep/engine/piece_finder.h"
#include "engines/stream/cells/tree_build.h"
#include "engines/stream/cells/tree_change.h"
#include "engines/stream/cells/tree_query.h"

namespace cellsweep::stream {
CellTree::CellTree(Crew& crew, const Kernels& kernels, PieceFinder* finder)
    : crew_(crew), kernels_(kernels), finder_(finder) {
  for (unsigned worker = 0; worker < crew.workers(); ++worker)
    scratches_.push_back(std::make_unique<Scratch>());
  found_.resize(scratches_.size());
  touched_.resize(scratches_.size());
}

void CellTree::allow(std::span<const BodyFilter> filters) {
  filters_ = filters;
  for (const auto& scratch : scratches_) {
    for (Keys* keys : {&scratch->found, &scratch->touched}) keys->allow(filters);
  }
}

void CellTree::limit_pairs(std::size_t most) {
  for (const auto& scratch : scratches_) scratch->found.buffer().most = scratch->touched.buffer().most = most;
}

void CellTree::clear() {
  reset(0);
  root_ = {};
}

void CellTree::reset(std::size_t boxes) {
  built_boxes_ = boxes;
  built_copies_ = 0;
  for (const auto& scratch : scratches_) {
    scratch->cells.reset(tuning::kBytesOfBox * boxes);
    scratch->job.reset(tuning::kBytesOfBox * boxes);
    for (Keys* keys : {&scratch->found, &scratch->touched}) keys->clear();
    scratch->collected.clear();
    scratch->copies = 0;
    scratch->most_copies = scratch->most_tests = ~std::uint64_t{0};
  }
}

void CellTree::give_back() {
  for (const auto& scratch : scratches_) {
    scratch->cells.fit();
    scratch->job = {};
    for (Keys* keys : {&scratch->found, &scratch->touched}) keys->give_back();
    scratch->collected = {};
  }
  std::fill(found_.begin(), found_.end(), std::span<const std::uint64_t>());
  std::fill(touched_.begin(), touched_.end(), std::span<const std::uint64_t>());
}

TreeBuilder CellTree::builder() {
  return {crew_, kernels_, scratches_, filters_, finder_ != nullptr};
}

void CellTree::build(const Boxes& boxes) {
  begin_build(boxes);
  fill_cells(boxes, 1);
  while (!is_built()) go_on(~std::uint64_t{0});
}

void CellTree::begin_build(const Boxes& boxes) {
  reset(boxes.count());
  filled_ = 0;
  cells_built_ = 0;
  placement_ = builder().place(boxes, root_);
}

void CellTree::take_working_memory(CellTree& other) {
  for (std::size_t worker = 0; worker < scratches_.size(); ++worker) {
    Scratch& mine = *scratches_[worker];
    Scratch& theirs = *other.scratches_[worker];
    std::swap(mine.job, theirs.job);
    mine.found = std::move(theirs.found);
    theirs.found.give_back();
  }
  std::fill(other.found_.begin(), other.found_.end(), std::span<const std::uint64_t>());
}

void CellTree::fill_cells(const Boxes& boxes, double share) {
  builder().fill(boxes, placement_, filled_, share);
  filled_ = share;
}

std::uint64_t CellTree::go_on(std::uint64_t boxes) {
  const std::uint32_t first = cells_built_;
  std::uint64_t sum = 0;
  // And those without boxes behind them: when all boxes are in cells the tree is built.
  while (!is_built() && (sum < boxes || placement_.cells[cells_built_].count == 0))
    sum += placement_.cells[cells_built_++].count;
  builder().finish(placement_, first, cells_built_, root_);
  if (is_built()) list_found();
  return sum;
}

void CellTree::list_found() {
  for (std::size_t worker = 0; worker < scratches_.size(); ++worker) {
    Scratch& scratch = *scratches_[worker];
    if (finder_ != nullptr) finder_->find(scratch.collected, scratch.found.buffer());
    scratch.found.leave_out();
    found_[worker] = scratch.found.view();
  }
  built_copies_ = copies();
}

// As many copies again as make a tree worn out, and as many comparisons as take about as long as a build.
void CellTree::begin_changes() {
  for (const auto& scratch : scratches_) {
    scratch->most_copies = scratch->copies + 2 * built_copies_ + tuning::kFewCopies;
    scratch->most_tests = scratch->tests + tuning::kTestsOfBuild * built_boxes_ + tuning::kFewTests;
  }
}

void CellTree::change(std::span<const FatBoxChange> changes) {
  begin_changes();
  for (const auto& scratch : scratches_) {
    scratch->job.release({});
    scratch->touched.clear();
  }
  TreeChanger(crew_, kernels_, scratches_).change(changes, root_);
  for (std::size_t worker = 0; worker < scratches_.size(); ++worker) {
    scratches_[worker]->touched.leave_out();
    touched_[worker] = scratches_[worker]->touched.view();
  }
}

void CellTree::change_found(std::span<const FatBoxChange> changes, const std::uint8_t* changed) {
  change(changes);
  for (std::size_t worker = 0; worker < scratches_.size(); ++worker) {
    Keys& found = scratches_[worker]->found;
    found.leave_out(changed);
    found.append(touched_[worker]);
    found_[worker] = found.view();
  }
}

void CellTree::change_one(const FatBoxChange& change) {
  scratches_[0]->job.release({});
  TreeChanger(crew_, kernels_, scratches_).change_one(change, root_);
}

void CellTree::find_partners(const Aabb& box, Keys& slots) {
  TreeQuery query(kernels_, slots.buffer());
  query.find(box, root_);
  scratches_[0]->tests += query.tests();
  if (scratches_[0]->tests > scratches_[0]->most_tests) throw TooMuchWork();
}

std::uint64_t CellTree::copies() const {
  std::uint64_t sum = 0;
  for (const auto& scratch : scratches_) sum += scratch->copies;
  return sum;
}

std::uint64_t CellTree::tests() const {
  std::uint64_t sum = 0;
  for (const auto& scratch : scratches_) sum += scratch->tests;
  return sum;
}

std::size_t CellTree::bytes() const {
  std::size_t sum = 0;
  for (const auto& scratch : scratches_) {
    sum += scratch->cells.bytes() + scratch->job.bytes() + scratch->collected.capacity() * sizeof(CellBoxes);
    sum += scratch->found.bytes() + scratch->touched.bytes();
  }
  return sum;
}

}  // namespace cellsweep::stream
