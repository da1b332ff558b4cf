/// @file
/// One-shot searches that do not get the memory or the threads that they ask for find all pairs when they are
/// called again.
#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "cellsweep/find_pairs.h"
#include "contract/box_kinds.h"
#include "contract/effort.h"
#include "contract/faults/starved_call.h"
#include "one_shot/sets_of_boxes.h"

namespace cellsweep::contract {
namespace {

/// What a visitor keeps without memory.
struct SeenPairs {
  std::uint64_t count = 0;
  std::uint64_t hash = 0;

  void add(std::uint32_t a, std::uint32_t b) {
    ++count;
    hash += mix64(std::uint64_t{a} << 32 | b);
  }
  friend bool operator==(const SeenPairs&, const SeenPairs&) = default;
};

void nothing() {}

class OneShotFaults : public testing::Test {
 protected:
  void TearDown() override { count_calls(false); }

  /// `sets` are one or two; `faults` counts those that happened.
  template <class AnyPair, class... Sets>
  void starve_all_forms(const std::vector<AnyPair>& truth, const FindPairsOptions& options,
                        const Sets&... sets) {
    SeenPairs all;
    for (const AnyPair& pair : truth) all.add(pair.a, pair.b);
    std::vector<AnyPair> listed;
    std::uint64_t count = 0;
    SeenPairs seen;
    const auto list = [&] {
      listed.clear();
      auto found = find_pairs(sets..., options);
      if (found) listed = std::move(*found);
      return found.status();
    };
    const auto count_them = [&] {
      count = ~std::uint64_t{0};
      const auto found = count_pairs(sets..., options);
      if (found) count = *found;
      return found.status();
    };
    const auto visit = [&] {
      seen = {};
      return visit_pairs(
          sets..., [&](AnyPair pair) { seen.add(pair.a, pair.b); }, options);
    };
    starve(list, [&] { return listed == truth; });
    starve(count_them, [&] { return count == truth.size(); });
    starve(visit, [&] { return seen == all; });
  }

  std::uint64_t faults_ = 0;

 private:
  template <class Call, class IsRight>
  void starve(const Call& call, const IsRight& is_right) {
    for (const Scarce scarce : {Scarce::memory, Scarce::threads}) {
      for (const Lasts lasts : {Lasts::once, Lasts::for_ever}) {
        faults_ += starve_each(
            scarce, lasts, nothing, call, [&](bool succeeded) { return !succeeded || is_right(); },
            {.each_of_first = effort(40U, 15U, 10U), .then_one_in = repeated(3U, effort(11U, 29U, 29U))});
        if (HasFailure()) return;
      }
    }
  }
};

const FindPairsOptions kAlone{.threads = 1};
const FindPairsOptions kThree{.threads = 3};

/// In one cell, swept, in pieces and in cells within cells.
constexpr std::array<std::size_t, 3> kSizes = {60, 400, effort(std::size_t{2500}, 2100, 2100)};

TEST_F(OneShotFaults, OfOneSetOrTwoOfFloats) {
  for (const std::size_t size : kSizes) {
    Random random(size);
    const std::vector<Aabb> boxes = make_boxes(box_kind("uniform"), random, size);
    const std::vector<Aabb> others = make_boxes(box_kind("uniform"), random, size / 2 + 3);
    for (const FindPairsOptions& options : {kAlone, kThree}) {
      SCOPED_TRACE(testing::Message() << size << " boxes, " << options.threads << " threads");
      starve_all_forms(one_shot::true_pairs(boxes), options, boxes);
      starve_all_forms(one_shot::true_pairs(boxes, others), options, boxes, others);
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(faults_, 200U) << "searches ask for memory in fewer places than there are";
}

TEST_F(OneShotFaults, OfDoublesAlsoWhereTheyAreSearchedTwice) {
  constexpr std::size_t kBoxes = effort(std::size_t{600}, 400, 400);
  const auto clusters = one_shot::two_tiny_clusters(kBoxes, 1);
  const auto others = one_shot::two_tiny_clusters(kBoxes / 2, 2);
  for (const FindPairsOptions& options : {kAlone, kThree}) {
    starve_all_forms(one_shot::true_pairs(clusters), options, clusters);
    starve_all_forms(one_shot::true_pairs(clusters, others), options, clusters, others);
    const auto flat = one_shot::cut_to<double, 2>(clusters);
    starve_all_forms(one_shot::true_pairs(flat), options, flat);
  }
  EXPECT_GT(faults_, 100U);
}

}  // namespace
}  // namespace cellsweep::contract
