#include "engines/stream/pairs/overlap_marks.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/pairs/pair_changes.h"
#include "base/threads/per_worker.h"
#include "base/tuning.h"
#include "geometry/box_lanes.h"

namespace cellsweep::stream {
namespace {

/// Returns the end of what it wrote. There is room for all; it may be that of the candidates.
SlotPair* copy_marked(std::span<const SlotPair> candidates, const std::uint8_t* marks, SlotPair* to) {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    *to = candidates[i];
    to += marks[i];
  }
  return to;
}

/// Nobody's share is empty.
unsigned workers_for(const Crew& crew, std::span<const SlotPair> candidates) {
  return candidates.size() < crew.active() ? 1 : crew.active();
}

/// What each worker writes: its share of the candidates' room, moved together afterwards.
class Outputs {
 public:
  Outputs(const TestOutput& room, std::span<const SlotPair> candidates, std::span<const SlotPair> ended,
          unsigned workers)
      : starts_(workers), ends_(workers) {
    for (unsigned worker = 0; worker < workers; ++worker) {
      const std::size_t first = Share::of(candidates.size(), worker, workers).first;
      const std::size_t ended_before = first == 0 ? 0 : count_below(ended, candidates[first]);
      starts_[worker] = {room.marks + first, room.began + first, room.ended + first + ended_before};
      ends_[worker] = starts_[worker];
    }
  }

  TestOutput& of(unsigned worker) { return ends_[worker]; }

  std::size_t gather(SlotPair* TestOutput::*list) {
    SlotPair* const start = starts_[0].*list;
    SlotPair* to = start;
    for (unsigned worker = 0; worker < starts_.size(); ++worker) {
      const SlotPair* from = starts_[worker].*list;
      const auto count = static_cast<std::size_t>(ends_[worker].*list - from);
      if (to != from) std::memmove(to, from, count * sizeof(SlotPair));
      to += count;
    }
    return static_cast<std::size_t>(to - start);
  }

 private:
  PerWorker<TestOutput> starts_;
  PerWorker<TestOutput> ends_;
};

}  // namespace

void OverlapMarks::mark_all(std::size_t candidates) {
  marks_.renew(candidates);
  std::fill_n(marks_.data(), candidates, std::uint8_t{1});
}

template <class Mark>
void OverlapMarks::mark(Crew& crew, std::span<const SlotPair> candidates, Mark&& mark) {
  marks_.renew(candidates.size());
  crew.run([&](unsigned worker) {
    const Share share = Share::of(candidates.size(), worker, crew.active());
    mark(candidates.subspan(share.first, share.last - share.first), marks_.data() + share.first);
  });
}

void OverlapMarks::test_all(Crew& crew, std::span<const SlotPair> candidates, const Aabb* boxes) {
  mark(crew, candidates,
       [boxes](std::span<const SlotPair> mine, std::uint8_t* marks) { mark_overlaps(mine, boxes, marks); });
}

void OverlapMarks::test_all(Crew& crew, std::span<const SlotPair> candidates, const BoxesBefore& boxes) {
  const auto box_of = [&](Slot slot) {
    return BoxLanes(boxes.fresh[slot] != 0 ? boxes.before[slot] : boxes.boxes[slot]);
  };
  mark(crew, candidates, [&](std::span<const SlotPair> mine, std::uint8_t* marks) {
    for (std::size_t i = 0; i < mine.size(); ++i) {
      prefetch_box(mine, i, boxes.boxes);
      marks[i] = overlap(box_of(mine[i].a), box_of(mine[i].b)) ? 1 : 0;
    }
  });
}

SlotPairChanges OverlapMarks::refresh(Crew& crew, std::span<const SlotPair> candidates,
                                      const SlotPairChanges& changes, const TestedBoxes& tested,
                                      PairRoom& room) {
  spare_.renew(candidates.size());
  auto& [began, ended] = room;
  began.renew(candidates.size());
  ended.renew(candidates.size() + changes.ended.size());
  const bool same = changes.began.empty() && changes.ended.empty();
  const unsigned workers = workers_for(crew, candidates);
  Outputs outputs({same ? marks_.data() : spare_.data(), began.data(), ended.data()}, candidates,
                  changes.ended, workers);
  const CandidateTest test{candidates, changes, marks_.data(), tested};
  crew.run([&](unsigned worker) {
    if (worker < workers) test_share(test, Share::of(candidates.size(), worker, workers), outputs.of(worker));
  });
  began.shrink(outputs.gather(&TestOutput::began));
  ended.shrink(outputs.gather(&TestOutput::ended));
  if (!same) std::swap(marks_, spare_);
  return {std::as_const(began).view(), std::as_const(ended).view()};
}

void OverlapMarks::leave_marked(Array<SlotPair>& candidates) const {
  const SlotPair* const end = copy_marked(candidates.view(), marks_.data(), candidates.data());
  candidates.shrink(static_cast<std::size_t>(end - candidates.data()));
}

// The marked ones are copied first: they are nearly those that overlapped before, where candidates are
// others each time.
SlotPairChanges OverlapMarks::compare(std::span<const SlotPair> before, std::span<const SlotPair> now,
                                      PairRoom& room) const {
  room.one.renew(now.size());
  room.other.renew(before.size());
  SlotPair* const end = copy_marked(now, marks_.data(), room.one.data());
  const auto [began, ended] =
      write_changes<SlotPair>(before, {room.one.data(), end}, {}, {room.one.data(), room.other.data()});
  room.one.shrink(static_cast<std::size_t>(began - room.one.data()));
  room.other.shrink(static_cast<std::size_t>(ended - room.other.data()));
  return {std::as_const(room.one).view(), std::as_const(room.other).view()};
}

void OverlapMarks::give_back() {
  spare_ = {};
  marks_.fit();
}

std::size_t OverlapMarks::bytes() const {
  return marks_.bytes() + spare_.bytes();
}

}  // namespace cellsweep::stream
