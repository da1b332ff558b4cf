#include "engines/stream/search/search.h"

#include <algorithm>

#include "base/tuning.h"

namespace cellsweep::stream {

Search::Search(Crew& crew, const Kernels& kernels, PieceFinder* finder, std::size_t max_pairs)
    : crew_(crew),
      kernels_(kernels),
      finder_(finder),
      max_pairs_(max_pairs),
      cells_(std::make_unique<CellTree>(crew, kernels, finder)) {}

std::size_t Search::generous_limit() const {
  const std::size_t of_pairs =
      max_pairs_ < kAnyNumber / 4 ? 2 * max_pairs_ + tuning::kFewCandidates : kAnyNumber;
  return std::min(of_pairs, most_candidates_);
}

// Fat boxes that overlap are no reason to refuse, but when there are very many, boxes are put in their place.
void Search::find_all(FatBoxes& fat_boxes, std::span<const Aabb> boxes, std::size_t most_swept) {
  if (fat_boxes.have_slack()) {
    try {
      return find_among({fat_boxes.by_slot(boxes), boxes.size()}, generous_limit(), most_swept);
    } catch (const TooManyPairs&) {
      fat_boxes.drop_slack();
    }
  }
  find_among(boxes, max_pairs_, most_swept);
}

void Search::find_among(std::span<const Aabb> boxes, std::size_t most, std::size_t most_swept) {
  has_cells_ = boxes.size() > most_swept || !sweep(boxes, most);
  if (has_cells_) {
    cells_->limit_pairs(most);
    cells_->build({boxes.data(), boxes.size()});
  } else {
    cells_->clear();
  }
}

// False when there is no way to sweep, or cells take less.
bool Search::sweep(std::span<const Aabb> boxes, std::size_t most) {
  if (finder_ != nullptr || kernels_.sweep == nullptr) return false;
  swept_.clear();
  swept_.buffer().most = most;
  if (!sweep_.find(kernels_, boxes, swept_)) return false;
  swept_view_ = swept_.view();
  return true;
}

bool Search::change(std::span<const FatBoxChange> changes) {
  try {
    cells_->limit_pairs(generous_limit());
    cells_->change(changes);
  } catch (const TooManyPairs&) {
    return false;
  } catch (const TooMuchWork&) {
    return false;
  }
  return true;
}

void Search::begin_prepared(const Boxes& boxes) {
  if (!prepared_) prepared_ = std::make_unique<CellTree>(crew_, kernels_);
  prepared_->take_working_memory(*cells_);
  prepared_->allow(cells_->filters());
  prepared_->limit_pairs(generous_limit());
  prepared_->begin_build(boxes);
}

void Search::use_prepared() {
  cells_.swap(prepared_);
  has_cells_ = true;
}

void Search::drop_prepared() {
  if (prepared_) prepared_->clear();
}

void Search::clear() {
  cells_->clear();
  has_cells_ = false;
  sweep_ = {};
  swept_ = {};
}

void Search::give_back() {
  cells_->give_back();
  drop_prepared();
  if (prepared_) prepared_->give_back();
  sweep_ = {};
  swept_.give_back();
  swept_view_ = {};
}

}  // namespace cellsweep::stream
