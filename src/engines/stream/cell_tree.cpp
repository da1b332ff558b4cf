#include "engines/stream/cell_tree.h"

#include "engines/stream/tree_build.h"
#include "engines/stream/tree_change.h"

namespace cellsweep::stream {
namespace {

/// More memory than this for each box is given back.
constexpr std::size_t kBytesOfBox = 512;

}  // namespace

CellTree::CellTree(Pool& pool, const Kernels& kernels) : pool_(pool), kernels_(kernels) {
  for (unsigned worker = 0; worker < pool.workers(); ++worker) {
    Desk& desk = *desks_.emplace_back(std::make_unique<Desk>());
    found_.push_back(&desk.found);
    began_.push_back(&desk.began);
    ended_.push_back(&desk.ended);
  }
}

void CellTree::build(const Boxes& boxes, const BodyId* ids) {
  for (const auto& desk : desks_) {
    desk->cells.reset(kBytesOfBox * boxes.count);
    desk->scratch.reset(kBytesOfBox * boxes.count);
    for (Keys* keys : {&desk->found, &desk->began, &desk->ended}) keys->clear();
    desk->copies = 0;
  }
  TreeBuilder(pool_, kernels_, desks_, ids).build(boxes, root_);
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
    sum += desk->cells.bytes() + desk->scratch.bytes();
    for (Keys* keys : {&desk->found, &desk->began, &desk->ended})
      sum += keys->buffer().capacity * sizeof(std::uint64_t);
  }
  return sum;
}

}  // namespace cellsweep::stream
