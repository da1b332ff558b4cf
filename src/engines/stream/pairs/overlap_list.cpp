#include "engines/stream/pairs/overlap_list.h"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

#include "geometry/box_lanes.h"
#include "engines/stream/pairs/pair_list.h"

namespace cellsweep::stream {
namespace {

constexpr std::uint64_t kNoKey = ~std::uint64_t{0};

std::size_t count_below(std::span<const Pair> pairs, const Pair& pair) {
  return static_cast<std::size_t>(std::lower_bound(pairs.begin(), pairs.end(), pair) - pairs.begin());
}

/// The candidates before, of which some ended, and the ones that began, walked along in step with those now.
class Walk {
 public:
  Walk(const PairChanges& changes, const std::uint8_t* old_marks, std::span<const Pair> now,
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
  bool next(std::uint64_t key, Pair*& ended) {
    if (key < next_change_) return *marks_++ != 0;
    take_ended(key, ended);
    const bool is_new = !began_.empty() && pair_key(began_.front()) == key;
    if (is_new) began_ = began_.subspan(1);
    look_ahead();
    return !is_new && *marks_++ != 0;
  }

  /// Those that ended below `key`.
  void take_ended(std::uint64_t key, Pair*& ended) {
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

  std::span<const Pair> began_;
  std::span<const Pair> ended_;
  const std::uint8_t* marks_;
  std::uint64_t next_change_ = kNoKey;
};

/// For candidates of which nothing is known from before.
struct Anew {
  static bool next(std::uint64_t, Pair*&) { return false; }
};

/// Where a worker writes, and how far it got.
struct Output {
  Pair* pairs;
  std::uint8_t* marks;
  Pair* began;
  Pair* ended;
};

/// Which candidates are tested: all, of boxes that are in the cache or are not, or those with a new box.
enum class Which { all_near, all_far, fresh };

/// A box that is far is asked for so many candidates before it is tested.
constexpr std::size_t kAhead = 16;
/// So many candidates and more are of boxes that are far.
constexpr std::size_t kFar = 20'000;

/// Tests candidates.
template <Which Tested, class Before, class SlotOf>
void test_pairs(std::span<const Pair> candidates, const TestedBoxes& tested, const SlotOf& slot_of,
                Before& before, Output& output) {
  Output to = output;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Pair pair = candidates[i];
    if (Tested == Which::all_far)
      __builtin_prefetch(&tested.boxes[slot_of(candidates[std::min(i + kAhead, candidates.size() - 1)].b)]);
    const bool was = before.next(pair_key(pair), to.ended);
    const auto a = slot_of(pair.a);
    const auto b = slot_of(pair.b);
    bool is = was;
    if (Tested != Which::fresh || tested.stamps[a] == tested.is_new || tested.stamps[b] == tested.is_new) {
      is = overlap(BoxLanes(tested.boxes[a]), BoxLanes(tested.boxes[b]));
    }
    *to.pairs = pair;
    to.pairs += is ? 1 : 0;
    *to.marks++ = is ? 1 : 0;
    if (is == was) continue;
    if (is) *to.began++ = pair;
    if (was) *to.ended++ = pair;
  }
  output = to;
}

template <Which Tested, class Before>
void test_share(std::span<const Pair> candidates, const TestedBoxes& tested, Before& before, Output& output) {
  const IdTable& table = tested.table;
  if (table.ids() == nullptr) {
    return test_pairs<Tested>(
        candidates, tested, [](BodyId id) { return id; }, before, output);
  }
  test_pairs<Tested>(
      candidates, tested, [&](BodyId id) { return table.find(id); }, before, output);
}

/// Nobody's share is empty.
unsigned workers_for(const Pool& pool, std::span<const Pair> candidates) {
  return candidates.size() < pool.active() ? 1 : pool.active();
}

/// What each worker writes: its share of the candidates' room, moved together afterwards.
class Outputs {
 public:
  Outputs(const Output& room, std::span<const Pair> candidates, std::span<const Pair> ended, unsigned workers)
      : starts_(workers) {
    for (unsigned worker = 0; worker < workers; ++worker) {
      const std::size_t first = Share::of(candidates.size(), worker, workers).first;
      const std::size_t ended_before = first == 0 ? 0 : count_below(ended, candidates[first]);
      starts_[worker] = {room.pairs + first, room.marks + first, room.began + first,
                         room.ended + first + ended_before};
    }
    ends_ = starts_;
  }

  Output& of(unsigned worker) { return ends_[worker]; }

  std::size_t gather(Pair* Output::*list) {
    Pair* const start = starts_[0].*list;
    Pair* to = start;
    for (std::size_t worker = 0; worker < starts_.size(); ++worker) {
      const Pair* from = starts_[worker].*list;
      const auto count = static_cast<std::size_t>(ends_[worker].*list - from);
      if (to != from) std::memmove(to, from, count * sizeof(Pair));
      to += count;
    }
    return static_cast<std::size_t>(to - start);
  }

 private:
  std::vector<Output> starts_;
  std::vector<Output> ends_;
};

}  // namespace

void OverlapList::make_room(std::size_t candidates, std::size_t ended) {
  spare_.renew(candidates);
  spare_marks_.renew(candidates);
  began_.renew(candidates);
  ended_.renew(candidates + ended);
}

void OverlapList::start(std::span<const Pair> candidates) {
  make_room(candidates.size(), 0);
  std::copy(candidates.begin(), candidates.end(), spare_.data());
  std::fill_n(spare_marks_.data(), candidates.size(), std::uint8_t{1});
  std::swap(pairs_, spare_);
  std::swap(marks_, spare_marks_);
}

PairChanges OverlapList::renew(Pool& pool, std::span<const Pair> candidates, const TestedBoxes& tested,
                               std::size_t most) {
  make_room(candidates.size(), 0);
  const unsigned workers = workers_for(pool, candidates);
  Outputs outputs({spare_.data(), spare_marks_.data(), began_.data(), ended_.data()}, candidates, {},
                  workers);
  pool.run([&](unsigned worker) {
    if (worker >= workers) return;
    const Share share = Share::of(candidates.size(), worker, workers);
    Anew before;
    test_share<Which::all_far>(candidates.subspan(share.first, share.last - share.first), tested, before,
                               outputs.of(worker));
  });
  spare_.shrink(outputs.gather(&Output::pairs));
  if (spare_.size() > most) throw TooManyPairs();
  const PairChanges changes = find_changes(pairs_.view(), spare_.view(), began_, ended_);
  std::swap(pairs_, spare_);
  std::swap(marks_, spare_marks_);
  return changes;
}

PairChanges OverlapList::refresh(Pool& pool, std::span<const Pair> candidates, const PairChanges& changes,
                                 const TestedBoxes& tested, std::size_t most) {
  make_room(candidates.size(), changes.ended.size());
  const unsigned workers = workers_for(pool, candidates);
  Outputs outputs({spare_.data(), spare_marks_.data(), began_.data(), ended_.data()}, candidates,
                  changes.ended, workers);
  pool.run([&](unsigned worker) {
    if (worker >= workers) return;
    const Share share = Share::of(candidates.size(), worker, workers);
    const auto mine = candidates.subspan(share.first, share.last - share.first);
    Output& output = outputs.of(worker);
    Walk before(changes, marks_.data(), candidates, share.first);
    if (tested.stamps != nullptr) {
      test_share<Which::fresh>(mine, tested, before, output);
    } else if (candidates.size() >= kFar) {
      test_share<Which::all_far>(mine, tested, before, output);
    } else {
      test_share<Which::all_near>(mine, tested, before, output);
    }
    const bool is_last = share.last == candidates.size();
    before.take_ended(is_last ? kNoKey : pair_key(candidates[share.last]), output.ended);
  });
  spare_.shrink(outputs.gather(&Output::pairs));
  if (spare_.size() > most) throw TooManyPairs();
  began_.shrink(outputs.gather(&Output::began));
  ended_.shrink(outputs.gather(&Output::ended));
  std::swap(pairs_, spare_);
  std::swap(marks_, spare_marks_);
  return {std::as_const(began_).view(), std::as_const(ended_).view()};
}

std::size_t OverlapList::bytes() const {
  return pairs_.bytes() + spare_.bytes() + began_.bytes() + ended_.bytes() + marks_.bytes() +
         spare_marks_.bytes();
}

}  // namespace cellsweep::stream
