#include <gtest/gtest.h>

#include <algorithm>

#include "bench/one_shot/box_sets.h"

namespace cellsweep::bench {
namespace {

std::vector<CrossPair> true_pairs_of(const BoxSets& sets) {
  const bool one = sets.b.empty();
  const std::vector<Aabb>& others = one ? sets.a : sets.b;
  std::vector<CrossPair> pairs;
  for (std::uint32_t i = 0; i < sets.a.size(); ++i) {
    for (std::uint32_t j = one ? i + 1 : 0; j < others.size(); ++j) {
      if (overlap(sets.a[i], others[j])) pairs.push_back({i, j});
    }
  }
  return pairs;
}

TEST(Searchers, FindThePairsOfEverySet) {
  for (const std::string_view scene : kSetScenes) {
    for (const std::string_view kind : kSetKinds) {
      const BoxSets sets = make_box_sets(scene, kind, 1500);
      EXPECT_EQ(sets.a.size() + sets.b.size(), 1500U);
      EXPECT_EQ(sets.b.empty(), kind == "one");
      const std::vector<CrossPair> truth = true_pairs_of(sets);
      EXPECT_FALSE(truth.empty()) << scene << ", " << kind << ": nothing to find";
      for (const SearcherInfo& info : own_searchers()) {
        if (kind == "one" && !info.takes_one_set) continue;
        const auto searcher = info.make();
        searcher->find(sets);
        EXPECT_EQ(searcher->count(), truth.size()) << info.name << ", " << scene << ", " << kind;
        std::vector<CrossPair> pairs;
        searcher->list(pairs);
        std::sort(pairs.begin(), pairs.end());
        EXPECT_EQ(pairs, info.lists ? truth : std::vector<CrossPair>()) << info.name;
      }
    }
  }
}

}  // namespace
}  // namespace cellsweep::bench
