/// @file
/// A history of pairs that does not get the memory that it asks for is as it was, and says what brute force
/// says when it is asked again.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <vector>

#include "cellsweep/pair_history.h"
#include "contract/box_kinds.h"
#include "contract/faults/starved_call.h"
#include "engines/oracle/brute_force.h"

namespace cellsweep::contract {
namespace {

constexpr std::size_t kRemembered = 100'000;
constexpr std::size_t kUpdates = 12;

std::vector<Pair> without(const std::vector<Pair>& all, const std::vector<Pair>& some) {
  std::vector<Pair> rest;
  std::ranges::set_difference(all, some, std::back_inserter(rest));
  return rest;
}

/// The pairs after each of some updates, of boxes that move more and more.
class HistoryFaults : public testing::Test {
 protected:
  HistoryFaults() {
    Random random(4);
    const BoxKind& kind = box_kind("uniform");
    std::vector<Aabb> boxes = make_boxes(kind, random, 60);
    pairs_.emplace_back();
    for (std::size_t update = 1; update <= kUpdates; ++update) {
      for (std::size_t i = 0; i < 5 * update; ++i)
        boxes[random.below(boxes.size())] = kind.make(random, i, 60);
      pairs_.push_back(brute_force_pairs(boxes));
    }
  }
  void TearDown() override { count_calls(false); }

  Status record(PairHistory& history, std::size_t number) const {
    const std::vector<Pair>& now = pairs_[number];
    const std::vector<Pair>& before = pairs_[number - 1];
    const std::vector<Pair> began = without(now, before);
    const std::vector<Pair> ended = without(before, now);
    return history.record(number, {began, ended});
  }

  PairHistory history_until(std::size_t number) const {
    PairHistory history(kRemembered);
    for (std::size_t i = 1; i <= number; ++i) EXPECT_TRUE(record(history, i).ok());
    return history;
  }

  /// A pair that ended and began again is in both lists.
  testing::AssertionResult says_all(PairHistory& history, std::size_t latest) const {
    for (std::size_t number = 0; number <= latest && latest > 0; ++number) {
      std::vector<Pair> kept = pairs_[number];
      for (std::size_t i = number; i <= latest; ++i)
        std::erase_if(kept, [&](const Pair& pair) { return !std::ranges::binary_search(pairs_[i], pair); });
      const auto changes = history.since(number);
      if (!changes) return testing::AssertionFailure() << changes.status().message;
      if (!std::ranges::equal(changes->began, without(pairs_[latest], kept)) ||
          !std::ranges::equal(changes->ended, without(pairs_[number], kept)))
        return testing::AssertionFailure() << "what changed since " << number << " is something else";
    }
    if (history.since(latest + 1).ok()) return testing::AssertionFailure() << "it knows of more updates";
    return testing::AssertionSuccess();
  }

  std::vector<std::vector<Pair>> pairs_;
};

TEST_F(HistoryFaults, ChangeNothingInARecord) {
  std::uint64_t faults = 0;
  for (std::size_t number = 1; number <= kUpdates; ++number) {
    const std::vector<Pair> began = without(pairs_[number], pairs_[number - 1]);
    const std::vector<Pair> ended = without(pairs_[number - 1], pairs_[number]);
    for (const Lasts lasts : {Lasts::once, Lasts::for_ever}) {
      std::optional<PairHistory> history;
      faults += starve_each(
          Scarce::memory, lasts, [&] { history.emplace(history_until(number - 1)); },
          [&] {
            return history->record(number, {began, ended});
          },
          [&](bool recorded) { return says_all(*history, recorded ? number : number - 1); });
    }
  }
  EXPECT_GT(faults, 4U);
}

TEST_F(HistoryFaults, ChangeNothingInAQuestionNorWhatTheLastOneGave) {
  PairHistory history = history_until(kUpdates);
  const std::vector<Pair>& now = pairs_[kUpdates];
  for (const Lasts lasts : {Lasts::once, Lasts::for_ever}) {
    std::optional<PairChanges> before;
    std::vector<Pair> began;
    const auto begin = [&] {
      before = *history.since(kUpdates - 1);
      began.assign(before->began.begin(), before->began.end());
    };
    const auto ask = [&] {
      const auto changes = history.since(0);
      if (changes) before = *changes;
      return changes.status();
    };
    const auto look = [&](bool answered) {
      return std::ranges::equal(before->began, answered ? now : began);
    };
    EXPECT_GT(starve_each(Scarce::memory, lasts, begin, ask, look), 2U);
    EXPECT_TRUE(says_all(history, kUpdates));
  }
}

TEST_F(HistoryFaults, LeaveNothingOfOneThatIsNotMade) {
  for (const Lasts lasts : {Lasts::once, Lasts::for_ever}) {
    std::optional<PairHistory> made;
    const auto make = [&] {
      made.reset();
      made.emplace(kRemembered);
      return Status();
    };
    EXPECT_GT(
        starve_each(
            Scarce::memory, lasts, [] {}, make, [&](bool is_made) { return made.has_value() == is_made; }),
        0U);
  }
}

}  // namespace
}  // namespace cellsweep::contract
