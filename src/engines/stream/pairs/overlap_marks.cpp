#include "engines/stream/pairs/overlap_marks.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>
#include <vector>

#include "base/pair_changes.h"
#include "base/tuning.h"
#include "geometry/box_lanes.h"

namespace cellsweep::stream {
namespace {

constexpr std::uint64_t kNoKey = ~std::uint64_t{0};

/// The candidates before, of which some ended, and the ones that began, walked along in step with those now.
class Walk {
 public:
  Walk(const SlotPairChanges& changes, const std::uint8_t* old_marks, std::span<const SlotPair> now,
       std::size_t first)
      : began_(changes.began), ended_(changes.ended), marks_(old_marks) {
    if (first > 0) {
      began_ = began_.subspan(count_below(began_, now[first]));
      ended_ = ended_.subspan(count_below(ended_, now[first]));
      marks_ += first + (changes.ended.size() - ended_.size()) - (changes.began.size() - began_.size());
    }
    look_ahead();
  }

  /// Whether the next candidate overlapped before; those that ended before it and did are written to `ended`.
  bool next(std::uint64_t key, SlotPair*& ended) {
    if (key < next_change_) return *marks_++ != 0;
    take_ended(key, ended);
    const bool is_new = !began_.empty() && pair_key(began_.front()) == key;
    if (is_new) began_ = began_.subspan(1);
    look_ahead();
    return !is_new && *marks_++ != 0;
  }

  /// How many of these, the next candidates, neither began nor follow one that ended.
  std::size_t unchanged(std::span<const SlotPair> next) const {
    if (next.empty() || pair_key(next.back()) < next_change_) return next.size();
    const auto is_below = [](const SlotPair& pair, std::uint64_t key) { return pair_key(pair) < key; };
    const auto end = std::lower_bound(next.begin(), next.end(), next_change_, is_below);
    return static_cast<std::size_t>(end - next.begin());
  }

  /// The marks of the next `count`, all of them unchanged().
  const std::uint8_t* take(std::size_t count) {
    marks_ += count;
    return marks_ - count;
  }

  /// Those that ended below `key`.
  void take_ended(std::uint64_t key, SlotPair*& ended) {
    while (!ended_.empty() && pair_key(ended_.front()) < key) {
      *ended = ended_.front();
      ended += *marks_++;
      ended_ = ended_.subspan(1);
    }
  }

 private:
  void look_ahead() {
    const std::uint64_t began = began_.empty() ? kNoKey : pair_key(began_.front());
    const std::uint64_t ended = ended_.empty() ? kNoKey : pair_key(ended_.front());
    next_change_ = std::min(began, ended);
  }

  std::span<const SlotPair> began_;
  std::span<const SlotPair> ended_;
  const std::uint8_t* marks_;
  std::uint64_t next_change_ = kNoKey;
};

/// The candidates before, when they are those of now.
class Same {
 public:
  Same(const std::uint8_t* marks, std::size_t first) : marks_(marks + first) {}
  bool next(std::uint64_t, SlotPair*&) { return *marks_++ != 0; }
  std::size_t unchanged(std::span<const SlotPair> next) const { return next.size(); }
  const std::uint8_t* take(std::size_t count) {
    marks_ += count;
    return marks_ - count;
  }
  void take_ended(std::uint64_t, SlotPair*&) {}

 private:
  const std::uint8_t* marks_;
};

/// Where a worker writes, and how far it got.
struct Output {
  std::uint8_t* marks;
  SlotPair* began;
  SlotPair* ended;
};

bool overlap(const Aabb* boxes, const SlotPair& pair) {
  return cellsweep::overlap(BoxLanes(boxes[pair.a]), BoxLanes(boxes[pair.b]));
}

/// Asks for the box of a candidate that will be tested soon.
void prefetch(std::span<const SlotPair> candidates, std::size_t i, const Aabb* boxes) {
  __builtin_prefetch(&boxes[candidates[std::min(i + tuning::kAhead, candidates.size() - 1)].b]);
}

template <bool Far, class Before>
void test_pairs(std::span<const SlotPair> candidates, const Aabb* boxes, Before& before, Output& output) {
  Output to = output;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const SlotPair pair = candidates[i];
    if (Far) prefetch(candidates, i, boxes);
    const bool was = before.next(pair_key(pair), to.ended);
    const bool is = overlap(boxes, pair);
    *to.marks++ = is ? 1 : 0;
    if (is == was) continue;
    if (is) *to.began++ = pair;
    if (was) *to.ended++ = pair;
  }
  output = to;
}

/// Of candidates that are what they were, tests those with a fresh box. Which these are nobody can foretell:
/// a list of them is made without a branch.
void test_fresh_of(std::span<const SlotPair> run, const TestedBoxes& tested, const std::uint8_t* old_marks,
                   Output& output) {
  std::array<std::uint16_t, tuning::kRun> picked;  // NOLINT(*-member-init): written before it is read
  std::size_t count = 0;
  for (std::size_t i = 0; i < run.size(); ++i) {
    picked[count] = static_cast<std::uint16_t>(i);
    count += (tested.fresh[run[i].a] | tested.fresh[run[i].b]) != 0 ? 1 : 0;
  }
  std::memmove(output.marks, old_marks, run.size());
  for (std::size_t k = 0; k < count; ++k) {
    __builtin_prefetch(&tested.boxes[run[picked[std::min(k + tuning::kAhead, count - 1)]].b]);
    const SlotPair pair = run[picked[k]];
    std::uint8_t& mark = output.marks[picked[k]];
    const bool was = mark != 0;
    const bool is = overlap(tested.boxes, pair);
    mark = is ? 1 : 0;
    *output.began = pair;
    *output.ended = pair;
    output.began += is && !was ? 1 : 0;
    output.ended += was && !is ? 1 : 0;
  }
  output.marks += run.size();
}

template <class Before>
void test_fresh(std::span<const SlotPair> candidates, const TestedBoxes& tested, Before& before,
                Output& output) {
  while (!candidates.empty()) {
    const std::size_t run = before.unchanged(candidates.first(std::min(candidates.size(), tuning::kRun)));
    if (run > 0) test_fresh_of(candidates.first(run), tested, before.take(run), output);
    candidates = candidates.subspan(run);
    const std::size_t changed = run < tuning::kRun ? std::min<std::size_t>(candidates.size(), 1) : 0;
    test_pairs<false>(candidates.first(changed), tested.boxes, before, output);
    candidates = candidates.subspan(changed);
  }
}

template <class Before>
void test_share(std::span<const SlotPair> candidates, bool far, const TestedBoxes& tested, Before& before,
                Output& output) {
  if (tested.fresh != nullptr) return test_fresh(candidates, tested, before, output);
  if (far) return test_pairs<true>(candidates, tested.boxes, before, output);
  test_pairs<false>(candidates, tested.boxes, before, output);
}

/// Returns the end of what it wrote. There is room for all.
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

std::span<const SlotPair> share_of(std::span<const SlotPair> candidates, const Share& share) {
  return candidates.subspan(share.first, share.last - share.first);
}

/// What each worker writes: its share of the candidates' room, moved together afterwards.
class Outputs {
 public:
  Outputs(const Output& room, std::span<const SlotPair> candidates, std::span<const SlotPair> ended,
          unsigned workers)
      : starts_(workers) {
    for (unsigned worker = 0; worker < workers; ++worker) {
      const std::size_t first = Share::of(candidates.size(), worker, workers).first;
      const std::size_t ended_before = first == 0 ? 0 : count_below(ended, candidates[first]);
      starts_[worker] = {room.marks + first, room.began + first, room.ended + first + ended_before};
    }
    ends_ = starts_;
  }

  Output& of(unsigned worker) { return ends_[worker]; }

  std::size_t gather(SlotPair* Output::*list) {
    SlotPair* const start = starts_[0].*list;
    SlotPair* to = start;
    for (std::size_t worker = 0; worker < starts_.size(); ++worker) {
      const SlotPair* from = starts_[worker].*list;
      const auto count = static_cast<std::size_t>(ends_[worker].*list - from);
      if (to != from) std::memmove(to, from, count * sizeof(SlotPair));
      to += count;
    }
    return static_cast<std::size_t>(to - start);
  }

 private:
  std::vector<Output> starts_;
  std::vector<Output> ends_;
};

}  // namespace

void OverlapMarks::make_room(std::size_t candidates, std::size_t ended) {
  spare_.renew(candidates);
  began_.renew(candidates);
  ended_.renew(candidates + ended);
}

void OverlapMarks::mark_all(std::size_t candidates) {
  marks_.renew(candidates);
  std::fill_n(marks_.data(), candidates, std::uint8_t{1});
}

template <class Test>
void OverlapMarks::mark(Crew& crew, std::span<const SlotPair> candidates, Test&& test) {
  marks_.renew(candidates.size());
  crew.run([&](unsigned worker) {
    const Share share = Share::of(candidates.size(), worker, crew.active());
    const auto mine = share_of(candidates, share);
    std::uint8_t* marks = marks_.data() + share.first;
    for (std::size_t i = 0; i < mine.size(); ++i) marks[i] = test(mine, i) ? 1 : 0;
  });
}

void OverlapMarks::test_all(Crew& crew, std::span<const SlotPair> candidates, const Aabb* boxes) {
  mark(crew, candidates, [boxes](std::span<const SlotPair> mine, std::size_t i) {
    prefetch(mine, i, boxes);
    return overlap(boxes, mine[i]);
  });
}

void OverlapMarks::test_all(Crew& crew, std::span<const SlotPair> candidates, const BoxesBefore& boxes) {
  const auto box_of = [&](Slot slot) {
    return BoxLanes(boxes.fresh[slot] != 0 ? boxes.before[slot] : boxes.boxes[slot]);
  };
  mark(crew, candidates, [&](std::span<const SlotPair> mine, std::size_t i) {
    prefetch(mine, i, boxes.boxes);
    return cellsweep::overlap(box_of(mine[i].a), box_of(mine[i].b));
  });
}

SlotPairChanges OverlapMarks::refresh(Crew& crew, std::span<const SlotPair> candidates,
                                      const SlotPairChanges& changes, const TestedBoxes& tested) {
  make_room(candidates.size(), changes.ended.size());
  const bool same = changes.began.empty() && changes.ended.empty();
  const bool far = candidates.size() >= tuning::kFar;
  const unsigned workers = workers_for(crew, candidates);
  Outputs outputs({same ? marks_.data() : spare_.data(), began_.data(), ended_.data()}, candidates,
                  changes.ended, workers);
  crew.run([&](unsigned worker) {
    if (worker >= workers) return;
    const Share share = Share::of(candidates.size(), worker, workers);
    const auto mine = share_of(candidates, share);
    Output& output = outputs.of(worker);
    if (same) {
      Same before(marks_.data(), share.first);
      return test_share(mine, far, tested, before, output);
    }
    Walk before(changes, marks_.data(), candidates, share.first);
    test_share(mine, far, tested, before, output);
    const bool is_last = share.last == candidates.size();
    before.take_ended(is_last ? kNoKey : pair_key(candidates[share.last]), output.ended);
  });
  began_.shrink(outputs.gather(&Output::began));
  ended_.shrink(outputs.gather(&Output::ended));
  if (!same) std::swap(marks_, spare_);
  return {std::as_const(began_).view(), std::as_const(ended_).view()};
}

// Where the lists and the marks differ nobody can foretell: there is no branch on them.
SlotPairChanges OverlapMarks::compare(std::span<const SlotPair> before, std::span<const SlotPair> now) {
  began_.renew(now.size());
  ended_.renew(before.size());
  SlotPair* began = began_.data();
  SlotPair* ended = ended_.data();
  const std::uint8_t* const was = spare_.data();
  const std::uint8_t* const is = marks_.data();
  std::size_t i = 0, j = 0;
  while (i < before.size() && j < now.size()) {
    const std::uint64_t key_before = pair_key(before[i]);
    const std::uint64_t key_now = pair_key(now[j]);
    const unsigned was_it = key_before <= key_now ? was[i] : 0U;
    const unsigned is_it = key_now <= key_before ? is[j] : 0U;
    *ended = before[i];
    *began = now[j];
    ended += was_it & ~is_it;
    began += is_it & ~was_it;
    i += key_before <= key_now ? 1 : 0;
    j += key_now <= key_before ? 1 : 0;
  }
  ended = copy_marked(before.subspan(i), was + i, ended);
  began = copy_marked(now.subspan(j), is + j, began);
  began_.shrink(static_cast<std::size_t>(began - began_.data()));
  ended_.shrink(static_cast<std::size_t>(ended - ended_.data()));
  return {std::as_const(began_).view(), std::as_const(ended_).view()};
}

SlotPairChanges OverlapMarks::compare_pairs(std::span<const SlotPair> before, std::span<const SlotPair> now) {
  find_changes<SlotPair>(before, now, {}, began_, ended_);
  return {std::as_const(began_).view(), std::as_const(ended_).view()};
}

void OverlapMarks::list_marked(std::span<const SlotPair> candidates, Array<SlotPair>& marked) const {
  marked.renew(candidates.size());
  const SlotPair* const end = copy_marked(candidates, marks_.data(), marked.data());
  marked.shrink(static_cast<std::size_t>(end - marked.data()));
}

void OverlapMarks::give_back() {
  spare_ = {};
  began_ = {};
  ended_ = {};
  marks_.fit();
}

std::size_t OverlapMarks::bytes() const {
  return marks_.bytes() + spare_.bytes() + began_.bytes() + ended_.bytes();
}

}  // namespace cellsweep::stream
