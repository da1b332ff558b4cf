/// @file
/// One-shot searches find what comparing all with all finds: every kind of boxes and of numbers, every form
/// of the result, whoever works and with which instructions.
#include "cellsweep/find_pairs.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cfloat>
#include <limits>
#include <new>
#include <stdexcept>
#include <utility>

#include "base/memory/starved.h"
#include "contract/box_kinds.h"
#include "contract/effort.h"
#include "engines/oracle/brute_force.h"
#include "float_settings.h"
#include "one_shot/sets_of_boxes.h"

namespace cellsweep::one_shot {
namespace {

using contract::effort;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr bool kSanitized = contract::kPace == contract::Pace::sanitized;

/// Who works: threads, and with which instructions; not all of them where boxes are many, or with sanitizers.
std::vector<FindPairsOptions> options_for(std::size_t boxes) {
#if defined(CELLSWEEP_THREAD_SANITIZED_TESTS)
  return {{.threads = 5}};
#endif
  if (kSanitized || boxes >= 1000) return {{.threads = 1, .isa = VectorIsa::portable}, {.threads = 5}};
  std::vector<FindPairsOptions> all;
  for (const unsigned threads : {1U, 2U, 5U}) all.push_back({.threads = threads});
  for (const VectorIsa isa : {VectorIsa::portable, VectorIsa::sse41, VectorIsa::avx2, VectorIsa::avx512}) {
    const FindPairsOptions options{.threads = 1, .isa = isa};
    if (find_pairs(std::vector<Aabb>(), options).ok()) all.push_back(options);
  }
  return all;
}

/// With sanitizers fewer, and the largest for some kinds of boxes only: `turn` numbers them.
std::vector<std::size_t> sizes_for(std::size_t turn) {
  std::vector<std::size_t> sizes = {0, 1, 2, 17, 63, 64, 65, 129, 400};
  if (kSanitized && !contract::is_long()) sizes = {1, 65, 400};
  if (!contract::kEmulated && contract::is_turn(0, turn)) sizes.push_back(effort(std::size_t{3000}, 2100, 0));
  return sizes;
}

/// A set of pairs, whose order does not matter.
struct SeenPairs {
  std::uint64_t count = 0;
  std::uint64_t hash = 0;

  void add(std::uint32_t a, std::uint32_t b) {
    ++count;
    hash += mix64(std::uint64_t{a} << 32 | b);
  }
  friend bool operator==(const SeenPairs&, const SeenPairs&) = default;
};

/// One set or two, and their pairs.
template <class AnyPair, class... Sets>
void expect_pairs(const std::vector<AnyPair>& truth, const FindPairsOptions& options, const Sets&... sets) {
  const auto listed = find_pairs(sets..., options);
  ASSERT_TRUE(listed.ok()) << listed.status().message;
  EXPECT_TRUE(*listed == truth) << listed->size() << " pairs listed of " << truth.size();
  const auto count = count_pairs(sets..., options);
  ASSERT_TRUE(count.ok()) << count.status().message;
  EXPECT_EQ(*count, truth.size());
  SeenPairs seen;
  const Status status = visit_pairs(
      sets..., [&](AnyPair pair) { seen.add(pair.a, pair.b); }, options);
  ASSERT_TRUE(status.ok()) << status.message;
  SeenPairs all;
  for (const AnyPair& pair : truth) all.add(pair.a, pair.b);
  EXPECT_EQ(seen, all) << seen.count << " pairs seen of " << all.count;
}

template <class AnyBox>
void expect_true_pairs(const std::vector<AnyBox>& boxes, const std::vector<AnyBox>& others,
                       std::span<const FindPairsOptions> options) {
  const std::vector<Pair> pairs = true_pairs(boxes);
  const std::vector<CrossPair> cross_pairs = true_pairs(boxes, others);
  for (const FindPairsOptions& some : options) {
    SCOPED_TRACE(testing::Message() << some.threads << " threads, instructions "
                                    << static_cast<int>(some.isa));
    expect_pairs(pairs, some, boxes);
    expect_pairs(cross_pairs, some, boxes, others);
  }
}

/// As they are compared.
std::vector<Aabb> made_canonical(std::vector<Aabb> boxes) {
  for (Aabb& box : boxes) box = contract::canonical_box(box);
  return boxes;
}

TEST(FindPairs, FindsThoseOfEveryKindOfBoxes) {
  std::size_t turn = 0;
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    for (const std::size_t size : sizes_for(turn++)) {
      SCOPED_TRACE(testing::Message() << size << " of " << kind);
      contract::Random random(size + 1);
      const auto boxes = contract::make_boxes(kind, random, size);
      const auto others = contract::make_boxes(kind, random, size / 2 + 3);
      const auto pairs = brute_force_pairs(boxes);
      const auto cross_pairs = true_pairs(made_canonical(boxes), made_canonical(others));
      for (const FindPairsOptions& some : options_for(size)) {
        expect_pairs(pairs, some, boxes);
        expect_pairs(cross_pairs, some, boxes, others);
        if (HasFailure()) return;
      }
    }
  }
}

TEST(FindPairs, FindsThoseBetweenSetsOfAnySizes) {
  const FindPairsOptions options{.threads = 2};
  constexpr std::size_t kMany = effort(5000, 2100, 2100);
  std::size_t turn = 0;
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    if (!contract::is_turn(1, turn++)) continue;
    contract::Random random(7);
    const auto many = made_canonical(contract::make_boxes(kind, random, kMany));
    for (const std::size_t size : {1, 256, 257}) {
      SCOPED_TRACE(testing::Message() << size << " of " << kind);
      const auto few = made_canonical(contract::make_boxes(kind, random, size));
      expect_pairs(true_pairs(few, many), options, few, many);
      expect_pairs(true_pairs(many, few), options, many, few);
    }
  }
}

TEST(FindPairs, FindsThoseOfBoxesInDoubles) {
  std::size_t turn = 0;
  for (const DoubleKind& kind : double_kinds()) {
    for (const std::size_t size : sizes_for(turn++)) {
      SCOPED_TRACE(testing::Message() << size << " of " << kind.name);
      expect_true_pairs(kind.make(size, 1), kind.make(size / 2 + 3, 2), options_for(size));
      if (HasFailure()) return;
    }
  }
}

TEST(FindPairs, FindsThoseOfBoxesInTwoDimensions) {
  const std::vector<FindPairsOptions> options = {{.threads = 1}, {.threads = 3}};
  for (const DoubleKind& kind : double_kinds()) {
    const bool is_float = std::string_view(kind.name) != "all magnitudes";
    for (const std::size_t size : {0, 1, 65, effort(1500, 400, 400)}) {
      SCOPED_TRACE(testing::Message() << size << " of " << kind.name);
      const auto boxes = kind.make(size, 1), others = kind.make(size, 2);
      expect_true_pairs(cut_to<double, 2>(boxes), cut_to<double, 2>(others), options);
      if (is_float) expect_true_pairs(cut_to<float, 2>(boxes), cut_to<float, 2>(others), options);
    }
  }
}

TEST(FindPairs, CountsDenormalsAndMinusZeroAsZeroInFloatsAndAsTheyAreInDoubles) {
  constexpr float kDenormal = std::numeric_limits<float>::denorm_min();
  const std::vector<Box<float, 2>> floats = {{{-1, 0}, {-kDenormal, 1}}, {{kDenormal, 0}, {1, 1}}};
  EXPECT_THAT(*find_pairs(floats), ElementsAre(Pair{0, 1}));
  EXPECT_THAT(*find_pairs(cut_to<double, 2>(floats)), IsEmpty());
  const std::vector<Box<double, 2>> zeros = {{{-1, 0}, {-0.0, 1}}, {{0.0, 0}, {1, 1}}};
  EXPECT_THAT(*find_pairs(zeros), ElementsAre(Pair{0, 1}));
}

TEST(FindPairs, TellsASetFromItself) {
  const std::vector<Box<float, 2>> boxes = {{{0, 0}, {2, 2}}, {{1, 1}, {3, 3}}, {{9, 9}, {10, 10}}};
  EXPECT_THAT(*find_pairs(boxes), ElementsAre(Pair{0, 1}));
  EXPECT_THAT(*find_pairs(boxes, boxes), ElementsAre(CrossPair{0, 0}, CrossPair{0, 1}, CrossPair{1, 0},
                                                     CrossPair{1, 1}, CrossPair{2, 2}));
}

TEST(FindPairs, TakesDefaultOptionsByBraces) {
  const std::vector<Aabb> boxes(3);
  EXPECT_EQ(find_pairs(boxes, {})->size(), 3U);
  EXPECT_EQ(*count_pairs(boxes, {.threads = 1}), 3U);
  EXPECT_EQ(find_pairs(boxes, boxes, {})->size(), 9U);
}

TEST(FindPairs, SearchesManyBoxesThatLieApartFromTheOtherSet) {
  contract::Random random(3);
  auto boxes = contract::make_boxes(contract::box_kind("uniform"), random, 3000);
  auto others = contract::make_boxes(contract::box_kind("uniform"), random, 2000);
  float highest = -FLT_MAX;
  for (const Aabb& box : boxes) highest = std::max(highest, box.max[0]);
  // Two of the others reach over to the boxes, one touches the last of them.
  for (Aabb& box : others) box.min[0] += 2 * highest + 100, box.max[0] += 2 * highest + 100;
  others[17] = boxes[40];
  others[1999] = boxes[2999];
  others[600].min = {highest, -1e6F, -1e6F};
  others[600].max = {2 * highest + 1, 1e6F, 1e6F};
  for (const unsigned threads : {1U, 3U}) {
    expect_pairs(true_pairs(boxes, others), {.threads = threads}, boxes, others);
    expect_pairs(true_pairs(others, boxes), {.threads = threads}, others, boxes);
  }
}

// Swept, all their pairs would be in memory before the first one is handed on.
TEST(FindPairs, FindsThoseOfHeapsInWhichAllOverlap) {
  for (const std::size_t size : {1000U, 3000U}) {
    const std::vector<Aabb> heap(size, Aabb{{0, 0, 0}, {1, 1, 1}});
    const std::uint64_t all = std::uint64_t{size} * (size - 1) / 2;
    for (const unsigned threads : {1U, 3U}) {
      const FindPairsOptions options{.threads = threads};
      EXPECT_EQ(*count_pairs(heap, options), all);
      SeenPairs seen;
      ASSERT_TRUE(visit_pairs(
                      heap, [&](Pair pair) { seen.add(pair.a, pair.b); }, options)
                      .ok());
      SeenPairs truth;
      for (BodyId a = 0; a < size; ++a) {
        for (BodyId b = a + 1; b < size; ++b) truth.add(a, b);
      }
      EXPECT_EQ(seen, truth) << size;
    }
  }
}

/// Of many boxes and of few: those that are swept, and those that come into cells.
class Visits : public testing::TestWithParam<std::size_t> {
 protected:
  std::vector<Aabb> boxes_ = [] {
    contract::Random random(5);
    return contract::make_boxes(contract::box_kind("uniform"), random, GetParam());
  }();
};

TEST_P(Visits, EndWhenTheVisitorHasSeenEnough) {
  const std::uint64_t all = *count_pairs(boxes_);
  ASSERT_GT(all, 3U);
  for (const std::uint64_t enough : {std::uint64_t{1}, std::uint64_t{2}, all - 1, all, all + 1}) {
    std::uint64_t seen = 0;
    EXPECT_TRUE(visit_pairs(boxes_, [&](Pair) { return ++seen < enough; }).ok());
    EXPECT_EQ(seen, std::min(enough, all));
    seen = 0;
    EXPECT_TRUE(visit_pairs(boxes_, boxes_, [&](CrossPair) { return ++seen < enough; }).ok());
    EXPECT_EQ(seen, enough) << "a set meets itself more often";
    seen = 0;
    const auto doubles = cut_to<double, 3>(boxes_);
    EXPECT_TRUE(visit_pairs(doubles, [&](Pair) { return ++seen < enough; }).ok());
    EXPECT_EQ(seen, std::min(enough, all));
  }
}

TEST_P(Visits, LetThroughWhatTheVisitorThrows) {
  const auto throws = [](Pair) -> bool { throw std::runtime_error("seen"); };
  EXPECT_THROW(static_cast<void>(visit_pairs(boxes_, throws)), std::runtime_error);
  EXPECT_EQ(find_pairs(boxes_)->size(), *count_pairs(boxes_)) << "nothing is left of it";
}

bool see_none(Pair) {
  return false;
}

TEST_P(Visits, CallFunctionsToo) {
  EXPECT_TRUE(visit_pairs(boxes_, see_none).ok());
}

INSTANTIATE_TEST_SUITE_P(FindPairs, Visits, testing::Values(40, 500, 3000, kSanitized ? 6000 : 20'000));

TEST(FindPairs, LeavesNothingWhereverMemoryRunsOut) {
  for (const std::size_t size : {20, 500, 2100}) {
    const auto boxes = double_kinds()[0].make(size, 1);
    const auto truth = true_pairs(boxes);
    const auto cross = true_pairs(boxes, boxes);
    const FindPairsOptions options{.threads = 2};
    std::vector<Pair> found;
    std::vector<CrossPair> crossing;
    const auto places = starve([] { return 0; },
                               [&](int) {
                                 found = *find_pairs(boxes, options);
                                 crossing = *find_pairs(boxes, boxes, options);
                               },
                               [](int) {},
                               [&](int) {
                                 EXPECT_EQ(found, truth);
                                 EXPECT_EQ(crossing, cross);
                               });
    EXPECT_GT(places, 3U) << "memory is asked for in fewer places than there are";
  }
}

TEST(FindPairs, DoesNotMindTheCallersFloatingPointSettings) {
  const auto boxes = two_tiny_clusters(2500, 1);
  const auto truth = true_pairs(boxes);
  for (const auto settings : all_float_settings()) {
    const auto [found, are_kept] = [&] {
      const FloatSettings of_caller(settings);
      const auto before = float_settings();
      auto pairs = find_pairs(boxes);
      return std::pair(std::move(pairs), float_settings() == before);
    }();
    EXPECT_TRUE(are_kept) << "settings " << settings;
    EXPECT_EQ(*found, truth) << "settings " << settings;
  }
}

}  // namespace
}  // namespace cellsweep::one_shot
