#include "engines/stream/pairs/resting_candidates.h"

#include <algorithm>
#include <utility>

#include "cellsweep/engine/engine.h"

namespace cellsweep::stream {

// A body that has come to rest meanwhile counts as awake: after many updates it is looked who rests anew.
bool RestingCandidates::begin_update(const BodyChanges& changes) {
  awake_.resize(changes.boxes.size(), 0);
  bool has_woken = false;
  for (const auto slots : {changes.moved, changes.inserted, changes.removed}) {
    for (const Slot slot : slots) has_woken |= wake(slot);
  }
  calm_ = has_woken && !are_parted_ ? 0 : calm_ + 1;
  return are_parted_ && (has_woken || calm_ > tuning::kMostCalm);
}

bool RestingCandidates::wake(Slot slot) {
  const bool rested = awake_[slot] == 0;
  awake_[slot] = 1;
  return rested;
}

void RestingCandidates::begin_anew(std::uint32_t patience) {
  std::fill_n(awake_.data(), awake_.size(), std::uint8_t{0});
  calm_ = 0;
  patience_ = std::min(patience, tuning::kMostPatienceToPart);
}

// Which candidates rest nobody can foretell: there is no branch.
void RestingCandidates::part(const MarkedCandidates& all) {
  const std::size_t size = all.pairs.size();
  SlotPair* const pairs = all.pairs.data();
  std::uint8_t* const marks = all.marks.data();
  const auto resting = static_cast<std::size_t>(
      std::count_if(pairs, pairs + size, [this](const SlotPair& pair) { return rest(pair); }));
  if (2 * resting < size) return begin_anew(2 * patience_);
  pairs_.renew(resting + 1);
  marks_.renew(resting + 1);
  std::size_t kept = 0;
  std::size_t taken = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const SlotPair pair = pairs[i];
    const std::uint8_t mark = marks[i];
    const bool rests = rest(pair);
    pairs_.data()[taken] = pairs[kept] = pair;
    marks_.data()[taken] = marks[kept] = mark;
    taken += rests ? 1 : 0;
    kept += rests ? 0 : 1;
  }
  pairs_.shrink(taken);
  marks_.shrink(taken);
  all.pairs.shrink(kept);
  all.marks.shrink(kept);
  all.pairs.fit();
  calm_ = 0;
  are_parted_ = true;
}

// They are parted again the later, the sooner somebody moved.
void RestingCandidates::reunite(const MarkedCandidates& others) {
  if (!are_parted_) return;
  Array<SlotPair> pairs;
  Array<std::uint8_t> marks;
  const std::size_t count = others.pairs.size();
  pairs.renew(count + size());
  marks.renew(count + size());
  std::size_t i = 0;
  std::size_t k = 0;
  for (std::size_t to = 0; to < pairs.size(); ++to) {
    const bool is_resting =
        i == count || (k < size() && pair_key(pairs_.data()[k]) < pair_key(others.pairs.data()[i]));
    pairs.data()[to] = is_resting ? pairs_.data()[k] : others.pairs.data()[i];
    marks.data()[to] = is_resting ? marks_.data()[k] : others.marks.data()[i];
    k += is_resting ? 1 : 0;
    i += is_resting ? 0 : 1;
  }
  others.pairs = std::move(pairs);
  others.marks = std::move(marks);
  pairs_ = {};
  marks_ = {};
  are_parted_ = false;
  begin_anew(calm_ < tuning::kCalmOfPatience * patience_ ? 2 * patience_ : tuning::kPatienceToPart);
}

}  // namespace cellsweep::stream
