#include "engines/stream/pairs/candidate_tests.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "base/pairs/pair_changes.h"
#include "geometry/box_lanes.h"

namespace cellsweep::stream {
namespace {

constexpr std::uint64_t kNoKey = ~std::uint64_t{0};
/// Candidates that are tested at a time.
constexpr std::size_t kBlock = 64;

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

bool overlap(const Aabb* boxes, const SlotPair& pair) {
  return cellsweep::overlap(BoxLanes(boxes[pair.a]), BoxLanes(boxes[pair.b]));
}

/// Which of the first `count` candidates, at most kBlock, overlap, a bit each. Nobody can foretell it: there
/// is no branch.
std::uint64_t overlaps_of(std::span<const SlotPair> candidates, std::size_t count, const Aabb* boxes) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < count; ++i) {
    prefetch_box(candidates, i, boxes);
    bits = bits >> 1 | std::uint64_t{overlap(boxes, candidates[i])} << (kBlock - 1);
  }
  return bits >> (kBlock - count);
}

std::uint64_t bits_of_eight(const std::uint8_t* marks) {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, marks, sizeof bytes);
  if constexpr (std::endian::native == std::endian::big) bytes = __builtin_bswap64(bytes);
  return bytes * 0x0102040810204080U >> 56;
}

/// So many marks, at most kBlock, as bits.
std::uint64_t bits_of(const std::uint8_t* marks, std::size_t count) {
  std::uint64_t bits = 0;
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8) bits |= bits_of_eight(marks + i) << i;
  for (; i < count; ++i) bits |= std::uint64_t{marks[i]} << i;
  return bits;
}

/// Candidates that are what they were, from the first of a list on.
struct Run {
  std::span<const SlotPair> candidates;  // and those behind them
  std::size_t count;
  const std::uint8_t* old_marks;
};

/// Tests all of them.
void test_all(const Run& run, const Aabb* boxes, TestOutput& output) {
  const std::uint64_t is = overlaps_of(run.candidates, run.count, boxes);
  const std::uint64_t was = bits_of(run.old_marks, run.count);
  std::memmove(output.marks, run.old_marks, run.count);
  for (std::uint64_t differ = is ^ was; differ != 0; differ &= differ - 1) {
    const auto i = static_cast<std::size_t>(std::countr_zero(differ));
    const auto began = static_cast<std::uint8_t>(is >> i & 1);
    output.marks[i] = began;
    *output.began = run.candidates[i];
    *output.ended = run.candidates[i];
    output.began += began;
    output.ended += 1 - began;
  }
  output.marks += run.count;
}

/// Tests all of more than kBlock.
void test_all_blocks(const Run& run, const Aabb* boxes, TestOutput& output) {
  for (std::size_t first = 0; first < run.count; first += kBlock) {
    const std::size_t count = std::min(run.count - first, kBlock);
    test_all({run.candidates.subspan(first), count, run.old_marks + first}, boxes, output);
  }
}

/// Tests those with a fresh box. Which these are nobody can foretell: a list of them is made without a
/// branch. Where it has many of them, all are tested, which takes less for each.
void test_fresh(const Run& run, const TestedBoxes& tested, TestOutput& output) {
  constexpr std::size_t kRoom = tuning::kRun + tuning::kAhead;
  std::array<std::uint16_t, kRoom> picked;  // NOLINT(*-member-init): written before it is read
  std::size_t count = 0;
  for (std::size_t i = 0; i < run.count; ++i) {
    const SlotPair pair = run.candidates[i];
    picked[count] = static_cast<std::uint16_t>(i);
    count += (tested.fresh[pair.a] | tested.fresh[pair.b]) != 0 ? 1 : 0;
  }
  if (tuning::kTestsOfPicked * count > run.count) return test_all_blocks(run, tested.boxes, output);
  // And those behind the run, whose boxes are on their way then.
  const std::size_t last = run.candidates.size() - 1;
  for (std::size_t k = 0; k < tuning::kAhead; ++k)
    picked[count + k] = static_cast<std::uint16_t>(std::min(run.count + k, last));
  std::memmove(output.marks, run.old_marks, run.count);
  for (std::size_t k = 0; k < count; ++k) {
    const SlotPair ahead = run.candidates[picked[k + tuning::kAhead]];
    __builtin_prefetch(&tested.boxes[ahead.a]);
    __builtin_prefetch(&tested.boxes[ahead.b]);
    const SlotPair pair = run.candidates[picked[k]];
    std::uint8_t& mark = output.marks[picked[k]];
    const bool was = mark != 0;
    const bool is = overlap(tested.boxes, pair);
    mark = is ? 1 : 0;
    *output.began = pair;
    *output.ended = pair;
    output.began += is && !was ? 1 : 0;
    output.ended += was && !is ? 1 : 0;
  }
  output.marks += run.count;
}

/// A candidate that may have begun, or follow one that ended.
void test_one(const SlotPair& pair, const Aabb* boxes, Walk& before, TestOutput& output) {
  const bool was = before.next(pair_key(pair), output.ended);
  const bool is = overlap(boxes, pair);
  *output.marks++ = is ? 1 : 0;
  if (is && !was) *output.began++ = pair;
  if (was && !is) *output.ended++ = pair;
}

void test_run(const Run& run, const TestedBoxes& tested, TestOutput& output) {
  if (tested.fresh != nullptr) return test_fresh(run, tested, output);
  test_all(run, tested.boxes, output);
}

}  // namespace

void test_share(const CandidateTest& test, const Share& share, TestOutput& output) {
  const std::size_t most = test.tested.fresh != nullptr ? tuning::kRun : kBlock;
  Walk before(test.changes, test.old_marks, test.candidates, share.first);
  auto rest = test.candidates.subspan(share.first, share.last - share.first);
  while (!rest.empty()) {
    const auto next = rest.first(std::min(rest.size(), most));
    const std::size_t count = before.unchanged(next);
    if (count > 0) test_run({rest, count, before.take(count)}, test.tested, output);
    rest = rest.subspan(count);
    if (count == next.size()) continue;
    test_one(rest.front(), test.tested.boxes, before, output);
    rest = rest.subspan(1);
  }
  const bool is_last = share.last == test.candidates.size();
  before.take_ended(is_last ? kNoKey : pair_key(test.candidates[share.last]), output.ended);
}

void mark_overlaps(std::span<const SlotPair> candidates, const Aabb* boxes, std::uint8_t* marks) {
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    prefetch_box(candidates, i, boxes);
    marks[i] = overlap(boxes, candidates[i]) ? 1 : 0;
  }
}

}  // namespace cellsweep::stream
