#include <algorithm>
#include <cstdint>
#include <string>

#include "base/tuning.h"
#include "bench/tuning/rows.h"
#include "cellsweep/engine/engine.h"
#include "engines/stream/pairs/candidate_list.h"
#include "engines/stream/pairs/overlap_marks.h"
#include "engines/stream/pairs/pairs_of_few.h"
#include "world/random.h"

namespace cellsweep::bench {
namespace {

/// Bodies of which one in `every` moves, and as candidates all that come near each other.
class Movers {
 public:
  Movers(std::size_t bodies, std::size_t every)
      : source_(uniform(bodies, 1)),
        now_(source_->boxes().begin(), source_->boxes().end()),
        before_(now_),
        fat_(now_) {
    for (Aabb& box : fat_) grow(box);
    cells_.build_seconds(fat_);
    candidates_.replace(cells_.tree.found());
    Random random(1);
    for (Slot slot = 0; slot < bodies; ++slot) {
      if (random.below(every) == 0) moved_.push_back(slot);
    }
    fresh_.resize(bodies, 0);
    marks_.test_all(cells_.crew, candidates(), now_.data());
  }

  double picked_seconds() {
    return quickest_seconds([&] {
      mark(1);
      marks_.refresh(cells_.crew, candidates(), {}, {now_.data(), fresh_.data()}, room_);
      mark(0);
    });
  }
  double all_seconds() {
    return quickest_seconds([&] {
      marks_.refresh(cells_.crew, candidates(), {}, {now_.data(), nullptr}, room_);
    });
  }
  /// To ask the cells of fat boxes that do not change.
  double query_seconds() {
    PairsOfFew pairs;
    return quickest_seconds([&] {
      const BodyChanges changes{
          .boxes = now_, .before = {before_}, .removed = {}, .moved = moved_, .inserted = {}};
      mark(1);
      pairs.begin(changes, fresh_.data());
      for (const Slot slot : moved_) {
        pairs.stayed(cells_.tree, slot, fat_[slot]);
        fresh_[slot] = PairsOfFew::kAsked;
      }
      mark(0);
      pairs.changes(cells_.crew);
    });
  }

  double moved() const { return static_cast<double>(moved_.size()); }
  double count() { return static_cast<double>(candidates().size()); }

 private:
  using PairsOfFew = stream::PairsOfFew;

  // A cube of edge 1 moves by 0.1 at most.
  static void grow(Aabb& box) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] -= 0.3F;
      box.max[axis] += 0.3F;
    }
  }

  /// In frames that differ: what repeats itself a processor foretells.
  double quickest_seconds(const std::function<void()>& work) {
    double quickest = 1e9;
    for (int frame = 0; frame < 6; ++frame) {
      source_->advance();
      before_ = now_;
      for (const Slot slot : moved_) now_[slot] = source_->boxes()[slot];
      quickest = std::min(quickest, seconds_of(work));
    }
    return quickest;
  }

  std::span<const SlotPair> candidates() { return candidates_.pairs(cells_.crew, room_); }
  void mark(std::uint8_t mark) {
    for (const Slot slot : moved_) fresh_[slot] = mark;
  }

  std::unique_ptr<FrameSource> source_;
  std::vector<Aabb> now_;
  std::vector<Aabb> before_;
  std::vector<Aabb> fat_;
  std::vector<Slot> moved_;
  std::vector<std::uint8_t> fresh_;
  Cells cells_;
  stream::CandidateList candidates_;
  stream::OverlapMarks marks_;
  stream::PairRoom room_;
};

/// In candidates, of which those with a new box are picked. About as many bodies move as there may.
Measured query_cost(std::size_t bodies) {
  Movers movers(bodies, tuning::kCandidatesOfQuery);
  const double query = movers.query_seconds() / movers.moved();
  const double candidate = movers.picked_seconds() / movers.count();
  return {{"measured", query / candidate}, {"in_code", tuning::kCandidatesOfQuery}};
}

/// Nanoseconds of a candidate by either way.
Measured picked_and_all(std::size_t bodies, std::size_t every) {
  Movers movers(bodies, every);
  const double to_ns = 1e9 / movers.count();
  return {{"picked", movers.picked_seconds() * to_ns}, {"all", movers.all_seconds() * to_ns}};
}

void register_shares(std::size_t bodies) {
  constexpr std::size_t kEvery = tuning::kFewFresh;
  for (const std::size_t every : {kEvery - 1, kEvery, kEvery + 1, 2 * kEvery, 4 * kEvery, 8 * kEvery})
    register_tuning_row("kFewFresh/" + std::to_string(every) + "/" + std::to_string(bodies),
                        [=] { return picked_and_all(bodies, every); });
}

}  // namespace

void register_candidate_rows() {
  for (const std::size_t bodies : {1000, 10'000, 100'000, 1'000'000})
    register_tuning_row("kCandidatesOfQuery/" + std::to_string(bodies),
                        [bodies] { return query_cost(bodies); });
  register_shares(10'000);
  register_shares(100'000);
}

}  // namespace cellsweep::bench
