#include "engines/stream/cells/cell_tree.h"

#include "base/tuning.h"
#include "cellsweep/engine/piece_finder.h"
#include "engines/stream/cells/tree_build.h"
#include "engines/stream/cells/tree_change.h"

namespace cellsweep::stream {
CellTree::CellTree(Crew& crew, const Kernels& kernels, PieceFinder* finder)
    : crew_(crew), kernels_(kernels), finder_(finder) {
  for (unsigned worker = 0; worker < crew.workers(); ++worker)
    scratches_.push_back(std::make_unique<Scratch>());
  found_.resize(scratches_.size());
  began_.resize(scratches_.size());
  ended_.resize(scratches_.size());
}

void CellTree::limit_pairs(std::size_t most) {
  for (const auto& scratch : scratches_) scratch->found.buffer().most = scratch->began.buffer().most = most;
}

void CellTree::build(const Boxes& boxes) {
  for (const auto& scratch : scratches_) {
    scratch->cells.reset(tuning::kBytesOfBox * boxes.count());
    scratch->job.reset(tuning::kBytesOfBox * boxes.count());
    for (Keys* keys : {&scratch->found, &scratch->began, &scratch->ended}) keys->clear();
    scratch->collected.clear();
    scratch->copies = 0;
  }
  const bool collects = finder_ != nullptr;
  TreeBuilder(crew_, kernels_, scratches_, collects).build(boxes, root_);
  for (std::size_t worker = 0; worker < scratches_.size(); ++worker) {
    Scratch& scratch = *scratches_[worker];
    if (collects) finder_->find(scratch.collected, scratch.found.buffer());
    found_[worker] = scratch.found.view();
  }
}

void CellTree::change(std::span<const FatBoxChange> changes) {
  for (const auto& scratch : scratches_) {
    scratch->job.release({});
    scratch->began.clear();
    scratch->ended.clear();
  }
  TreeChanger(crew_, kernels_, scratches_).change(changes, root_);
  for (std::size_t worker = 0; worker < scratches_.size(); ++worker) {
    began_[worker] = scratches_[worker]->began.view();
    ended_[worker] = scratches_[worker]->ended.view();
  }
}

std::uint64_t CellTree::copies() const {
  std::uint64_t sum = 0;
  for (const auto& scratch : scratches_) sum += scratch->copies;
  return sum;
}

std::size_t CellTree::bytes() const {
  std::size_t sum = 0;
  for (const auto& scratch : scratches_) {
    sum += scratch->cells.bytes() + scratch->job.bytes() + scratch->collected.capacity() * sizeof(CellBoxes);
    for (Keys* keys : {&scratch->found, &scratch->began, &scratch->ended})
      sum += keys->buffer().capacity * sizeof(std::uint64_t);
  }
  return sum;
}

}  // namespace cellsweep::stream
