/// @file
/// Pairs, their order, and the hash of a set of them. The constants were computed apart from this code, with
/// whole numbers of any size; those of seeds 0 and 1 are the published first outputs of splitmix64.
#include "cellsweep/pair.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace cellsweep {
namespace {

std::uint64_t hash_of(const std::vector<Pair>& pairs) {
  return pair_set_hash(pairs);
}

TEST(Pair, PutsTheSmallerIdFirst) {
  EXPECT_EQ(make_pair_of(1, 2), (Pair{1, 2}));
  EXPECT_EQ(make_pair_of(2, 1), (Pair{1, 2}));
  EXPECT_EQ(make_pair_of(0xffffffff, 0), (Pair{0, 0xffffffff}));
  EXPECT_EQ(make_pair_of(0x80000000, 0x7fffffff), (Pair{0x7fffffff, 0x80000000}));
}

TEST(Pair, KeysAreInTheOrderOfPairs) {
  const std::vector<Pair> ascending = {{0, 1},          {0, 0xffffffff},          {1, 2},
                                       {1, 0x80000000}, {0x7fffffff, 0x80000000}, {0xfffffffe, 0xffffffff}};
  for (std::size_t i = 1; i < ascending.size(); ++i) {
    EXPECT_LT(ascending[i - 1], ascending[i]);
    EXPECT_LT(pair_key(ascending[i - 1]), pair_key(ascending[i]));
  }
  EXPECT_EQ(pair_key(Pair{0x12345678, 0x9abcdef0}), 0x123456789abcdef0ULL);
}

TEST(PairSetHash, IsTheOneComputedElsewhere) {
  EXPECT_EQ(hash_of({}), 0U);
  EXPECT_EQ(mix64(0x9e3779b97f4a7c15ULL), 0xe220a8397b1dcdafULL);
  EXPECT_EQ(hash_of({{0, 1}}), 0x910a2dec89025cc1ULL);
  EXPECT_EQ(hash_of({{0, 1}, {0, 2}, {1, 2}}), 0xb52222ea01c57a2dULL);
  EXPECT_EQ(hash_of({{1, 2}, {3, 4}}), 0x15e65cf65b07fdffULL);
  EXPECT_EQ(hash_of({{0, 0xffffffff}}), 0x73b13ba2aff181c0ULL);
  EXPECT_EQ(hash_of({{0xfffffffe, 0xffffffff}}), 0x19ba2418afbbfae1ULL);
}

TEST(PairSetHash, OfAllPairsOfTwentyBodiesIsTheOneComputedElsewhereInAnyOrder) {
  std::vector<Pair> pairs;
  for (BodyId b = 0; b < 20; ++b) {
    for (BodyId a = 0; a < b; ++a) pairs.push_back({a, b});
  }
  EXPECT_EQ(hash_of(pairs), 0xd53ecae9628bca7dULL);
  std::reverse(pairs.begin(), pairs.end());
  EXPECT_EQ(hash_of(pairs), 0xd53ecae9628bca7dULL);
}

TEST(PairSetHash, IsPrintedAsSixteenLowerCaseDigits) {
  EXPECT_EQ(hash_text(0), "0000000000000000");
  EXPECT_EQ(hash_text(0xab), "00000000000000ab");
  EXPECT_EQ(hash_text(0xfedcba9876543210ULL), "fedcba9876543210");
}

}  // namespace
}  // namespace cellsweep
