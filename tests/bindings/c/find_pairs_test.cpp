/// @file
/// One-shot searches through the face for C: the same pairs as in C++.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "bindings/c/c_world.h"
#include "cellsweep/find_pairs.h"
#include "contract/box_kinds.h"
#include "contract/random.h"

namespace cellsweep::c {
namespace {

using Visited = std::vector<Pair>;

bool note(void* context, cellsweep_pair pair) {
  static_cast<Visited*>(context)->push_back({pair.a, pair.b});
  return true;
}

bool note_one(void* context, cellsweep_pair pair) {
  note(context, pair);
  return false;
}

Visited sorted(Visited pairs) {
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

struct Counted {
  std::uint64_t among = 0;
  std::uint64_t between = 0;
};

TEST(CFindPairs, FindsWhatCppFindsOnEveryKindOfBox) {
  contract::Random random(5);
  const PairList list = make_list();
  for (const contract::BoxKind& kind : contract::box_kinds()) {
    SCOPED_TRACE(kind.name);
    const std::vector<Aabb> boxes = contract::make_boxes(kind, random, 100);
    const std::vector<Aabb> others = contract::make_boxes(kind, random, 80);
    const auto among = find_pairs(boxes);
    ASSERT_TRUE(among.ok());
    ASSERT_EQ(cellsweep_find_pairs(boxes_in(boxes), nullptr, list.get(), nullptr), CELLSWEEP_OK);
    EXPECT_EQ(pairs_in(list), *among);
    Visited between;
    const auto found = find_pairs(boxes, others);
    ASSERT_TRUE(found.ok());
    for (const CrossPair& pair : *found) between.push_back({pair.a, pair.b});
    ASSERT_EQ(cellsweep_find_pairs_between(boxes_in(boxes), boxes_in(others), nullptr, list.get(), nullptr),
              CELLSWEEP_OK);
    EXPECT_EQ(pairs_in(list), between);
    Counted counted;
    ASSERT_EQ(cellsweep_count_pairs(boxes_in(boxes), nullptr, &counted.among, nullptr), CELLSWEEP_OK);
    ASSERT_EQ(
        cellsweep_count_pairs_between(boxes_in(boxes), boxes_in(others), nullptr, &counted.between, nullptr),
        CELLSWEEP_OK);
    EXPECT_EQ(counted.among, among->size());
    EXPECT_EQ(counted.between, between.size());
    Visited visited;
    ASSERT_EQ(cellsweep_visit_pairs(boxes_in(boxes), nullptr, note, &visited, nullptr), CELLSWEEP_OK);
    EXPECT_EQ(sorted(visited), *among);
    visited.clear();
    ASSERT_EQ(
        cellsweep_visit_pairs_between(boxes_in(boxes), boxes_in(others), nullptr, note, &visited, nullptr),
        CELLSWEEP_OK);
    EXPECT_EQ(sorted(visited), between);
  }
}

TEST(CFindPairs, AVisitorStopsWhenItHasEnough) {
  const std::vector<Aabb> boxes(5, Aabb{{0, 0, 0}, {1, 1, 1}});
  Visited visited;
  EXPECT_EQ(cellsweep_visit_pairs(boxes_in(boxes), nullptr, note_one, &visited, nullptr), CELLSWEEP_OK);
  EXPECT_EQ(visited.size(), 1U);
}

TEST(CFindPairs, ASearchThatFailsLeavesTheList) {
  const std::vector<Aabb> boxes(5, Aabb{{0, 0, 0}, {1, 1, 1}});
  const PairList list = make_list();
  ASSERT_EQ(cellsweep_find_pairs(boxes_in(boxes), nullptr, list.get(), nullptr), CELLSWEEP_OK);
  const Visited before = pairs_in(list);
  EXPECT_EQ(before.size(), 10U);
  cellsweep_failure why;
  cellsweep_find_options options = {};
  options.size = sizeof options;
  options.max_pairs = 9;
  EXPECT_EQ(cellsweep_find_pairs(boxes_in(boxes), &options, list.get(), &why), CELLSWEEP_CAPACITY);
  EXPECT_STREQ(why.setting, "max_pairs");
  EXPECT_EQ(why.limit, 9U);
  EXPECT_EQ(pairs_in(list), before);
  const double flat[] = {0, 0, 1, 1};
  const cellsweep_boxes others = cellsweep_boxes_apart(CELLSWEEP_DOUBLE, 2, flat, flat + 2, 0, 1);
  EXPECT_EQ(cellsweep_find_pairs_between(boxes_in(boxes), others, nullptr, list.get(), &why),
            CELLSWEEP_BAD_INPUT);
  EXPECT_EQ(pairs_in(list), before);
}

}  // namespace
}  // namespace cellsweep::c
