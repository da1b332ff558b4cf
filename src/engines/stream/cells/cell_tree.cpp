#include "engines/stream/cells/cell_tree.h"

#include "engines/stream/cells/tree_build.h"
#include "engines/stream/cells/tree_change.h"

namespace cellsweep::stream {
namespace {

/// More memory than this for each box is given back.
constexpr std::size_t kBytesOfBox = 512;

}  // namespace

CellTree::CellTree(Pool& pool, const Kernels& kernels, PieceFinder* finder)
    : pool_(pool), kernels_(kernels), finder_(finder) {
  for (unsigned worker = 0; worker < pool.workers(); ++worker) {
    Desk& desk = *desks_.emplace_back(std::make_unique<Desk>());
    found_.push_back(&desk.found);
    began_.push_back(&desk.began);
    ended_.push_back(&desk.ended);
  }
}

void CellTree::limit_pairs(std::size_t most) {
  for (const auto& desk : desks_) desk->found.buffer().most = desk->began.buffer().most = most;
}

void CellTree::build(const Boxes& boxes, const BodyId* ids) {
  for (const auto& desk : desks_) {
    desk->cells.reset(kBytesOfBox * boxes.count());
    desk->scratch.reset(kBytesOfBox * boxes.count());
    for (Keys* keys : {&desk->found, &desk->began, &desk->ended}) keys->clear();
    desk->collected.clear();
    desk->copies = 0;
  }
  const bool collects = finder_ != nullptr;
  TreeBuilder(pool_, kernels_, desks_, ids, collects).build(boxes, root_);
  if (!collects) return;
  for (const auto& desk : desks_) finder_->find(desk->collected, ids, desk->found.buffer());
}

void CellTree::change(std::span<const Change> changes, const BodyId* ids) {
  for (const auto& desk : desks_) {
    desk->scratch.release({});
    desk->began.clear();
    desk->ended.clear();
  }
  TreeChanger(pool_, kernels_, desks_, ids).change(changes, root_);
}

std::uint64_t CellTree::copies() const {
  std::uint64_t sum = 0;
  for (const auto& desk : desks_) sum += desk->copies;
  return sum;
}

std::size_t CellTree::bytes() const {
  std::size_t sum = 0;
  for (const auto& desk : desks_) {
    sum += desk->cells.bytes() + desk->scratch.bytes() + desk->collected.capacity() * sizeof(CellBoxes);
    for (Keys* keys : {&desk->found, &desk->began, &desk->ended})
      sum += keys->buffer().capacity * sizeof(std::uint64_t);
  }
  return sum;
}

}  // namespace cellsweep::stream
