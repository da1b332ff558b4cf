/// @file
/// A list that follows its changes a part at a time, against a set.
#include "base/pairs/pair_list.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <vector>

#include "base/memory/starved.h"
#include "base/tuning.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using contract::Random;

/// A list and what should be in it. Slots stand for ids where pairs are of slots.
template <class AnyPair>
struct Followed {
  Followed(std::size_t pairs, std::uint64_t seed) : random(seed) {
    while (truth.size() < pairs) truth.insert(any_pair());
    list.pairs().renew(truth.size());
    std::ranges::copy(truth, list.pairs().data());
  }

  AnyPair any_pair() {
    const auto a = static_cast<std::uint32_t>(random.below(1000));
    return {a, static_cast<std::uint32_t>(a + 1 + random.below(1000))};
  }

  /// So many changes, some of which take back what was changed before.
  void change(std::size_t count) {
    list.reserve_notes(count);
    for (std::size_t i = 0; i < count; ++i) {
      AnyPair pair = random.one_in(4) ? last : any_pair();
      // One that is there.
      if (random.one_in(2) && !truth.empty()) pair = *truth.begin();
      if (truth.erase(pair) == 0) truth.insert(pair);
      list.note(pair_key(pair));
      last = pair;
    }
  }
  /// A part of what waits is in the next list.
  void begin_to_merge(std::size_t more = 1) {
    const std::size_t many = truth.size() / tuning::kPairsOfNote + tuning::kFewNotes;
    change(many - 500);
    list.go_on(spare);
    change(500 + more);
    list.go_on(spare);
  }
  bool is_right() { return std::ranges::equal(list.all(spare).view(), truth); }

  Random random;
  std::set<AnyPair> truth;
  AnyPair last = {1, 2};
  PairList<AnyPair> list;
  Array<AnyPair> spare;
};

template <class AnyPair>
class PairListTest : public testing::Test {};

using BothPairs = testing::Types<Pair, SlotPair>;
TYPED_TEST_SUITE(PairListTest, BothPairs, );

TYPED_TEST(PairListTest, IsRightWheneverSomebodyLooks) {
  for (const std::size_t pairs : {0, 100, 5000, 20'000}) {
    for (const std::size_t seldom : {1, 5, 30, 200}) {
      Followed<TypeParam> followed(pairs, pairs + seldom);
      for (int step = 0; step < 400; ++step) {
        followed.change(followed.random.one_in(20) ? 3000 : followed.random.below(100));
        followed.list.go_on(followed.spare);
        if (!followed.random.one_in(seldom)) continue;
        ASSERT_TRUE(followed.is_right()) << pairs << " pairs, step " << step;
        ASSERT_TRUE(followed.list.is_up_to_date());
        ASSERT_EQ(followed.list.new_notes(), 0U);
      }
      ASSERT_TRUE(followed.is_right());
    }
  }
}

// What is merged a part at a time is not all done by whoever has one change.
TYPED_TEST(PairListTest, IsWalkedByNoCallThatDoesNotAskForIt) {
  constexpr std::size_t kPairs = 40'000;
  constexpr std::size_t kMany = kPairs / tuning::kPairsOfNote + tuning::kFewNotes;
  Followed<TypeParam> followed(kPairs, 1);
  const TypeParam* const first = followed.list.pairs().data();
  std::size_t notes = 0;
  const auto change_until = [&](auto&& is_done) {
    for (; !is_done(); ++notes) {
      followed.change(1);
      followed.list.go_on(followed.spare);
    }
  };
  change_until([&] { return notes > kMany; });
  const std::size_t begun = notes;
  change_until([&] { return followed.list.pairs().data() != first; });
  // It takes a part of the list for each note, but is done before as many wait again.
  EXPECT_GT(notes - begun, kPairs / tuning::kStepsOfNote / 2);
  EXPECT_LT(notes - begun, kMany);
  EXPECT_TRUE(followed.is_right());
}

TYPED_TEST(PairListTest, ForgetsNewNotesAndNoOthers) {
  Followed<TypeParam> followed(20'000, 2);
  for (int round = 0; round < 300; ++round) {
    followed.change(50);
    followed.list.go_on(followed.spare);
    const auto kept = followed.truth;
    followed.change(30);
    EXPECT_EQ(followed.list.new_notes(), 30U);
    followed.list.forget_new_notes();
    followed.truth = kept;
  }
  EXPECT_TRUE(followed.is_right());
}

TYPED_TEST(PairListTest, BecomesAnotherWhateverWaits) {
  Followed<TypeParam> followed(20'000, 3);
  followed.begin_to_merge();
  followed.change(10);
  EXPECT_FALSE(followed.list.is_up_to_date());
  followed.list.forget_notes();
  EXPECT_TRUE(followed.list.is_up_to_date());
  followed.list.pairs().shrink(0);
  EXPECT_EQ(followed.list.all(followed.spare).size(), 0U);
}

TYPED_TEST(PairListTest, GivesBackWhatIsNotNeededToHoldIt) {
  Followed<TypeParam> followed(20'000, 4);
  Array<TypeParam> larger;
  larger.renew(100'000);
  std::ranges::copy(followed.truth, larger.data());
  larger.shrink(followed.truth.size());
  std::swap(followed.list.pairs(), larger);
  for (int step = 0; step < 100; ++step) {
    followed.change(100);
    followed.list.go_on(followed.spare);
    if (step >= 40) followed.list.give_back();  // a part is merged
  }
  EXPECT_TRUE(followed.is_right());
  followed.list.give_back();
  EXPECT_LE(followed.list.bytes(), 2 * followed.truth.size() * sizeof(TypeParam));
  EXPECT_TRUE(followed.is_right());
}

// Its memory could not be given back before.
TYPED_TEST(PairListTest, TakesWhatWasTakenUpWhileNothingChanges) {
  for (const std::size_t more : {200, 1000}) {
    Followed<TypeParam> followed(20'000, 6);
    followed.begin_to_merge(more);
    EXPECT_FALSE(followed.list.is_up_to_date());
    std::uint32_t updates = 0;
    for (; !followed.list.is_up_to_date(); ++updates) followed.list.go_on_at_rest(followed.spare);
    EXPECT_GE(updates, tuning::kPartsAtRest / 8) << "a part at a time";
    EXPECT_LT(updates, tuning::kQuietToGiveBack);
    followed.list.give_back();
    EXPECT_LE(followed.list.bytes(), 2 * followed.truth.size() * sizeof(TypeParam) + 20'000);
    EXPECT_TRUE(followed.is_right());
    followed.change(100);
    followed.list.go_on(followed.spare);
    followed.list.go_on_at_rest(followed.spare);
    EXPECT_EQ(followed.list.notes(), 100U) << "they may wait";
  }
}

TYPED_TEST(PairListTest, WithoutMemoryIsWhatItWas) {
  using State = std::unique_ptr<Followed<TypeParam>>;
  const auto ignore = [](const State&) {};
  const auto is_right = [](const State& state) { EXPECT_TRUE(state->is_right()); };
  for (const bool merges : {false, true}) {
    const auto make = [=] {
      auto followed = std::make_unique<Followed<TypeParam>>(20'000, 5);
      if (merges) followed->begin_to_merge();
      followed->change(4000);
      return followed;
    };
    const auto go_on = [](const State& state) { state->list.go_on(state->spare); };
    EXPECT_EQ(starve(make, go_on, ignore, is_right), merges ? 0U : 3U);
    const auto list_all = [](const State& state) { state->list.all(state->spare); };
    EXPECT_GE(starve(make, list_all, ignore, is_right), 2U);
  }
}

}  // namespace
}  // namespace cellsweep
