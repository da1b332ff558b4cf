#include "engines/embree/collider.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "cellsweep/engine/engine.h"
#include "engines/oracle/brute_force.h"

namespace cellsweep::embree {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<Pair> pairs_of(const std::vector<Aabb>& boxes, unsigned threads = 0) {
  Collider collider(threads);
  collider.build(boxes);
  std::vector<Pair> pairs;
  for (const auto part : collider.find_pairs()) {
    for (const std::uint64_t key : part)
      pairs.push_back({static_cast<BodyId>(key >> 32), static_cast<BodyId>(key)});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(EmbreeCollider, FindsEachPairOnceThoughEmbreeTellsItTwice) {
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_THAT(pairs_of({box, box, box}), ElementsAre(Pair{0, 1}, Pair{0, 2}, Pair{1, 2}));
}

TEST(EmbreeCollider, TakesTouchesAndRefusesGapsOfOneFloatStep) {
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  const float next = std::nextafter(1.0F, 2.0F);
  EXPECT_THAT(pairs_of({box, {{1, 1, 1}, {2, 2, 2}}}), ElementsAre(Pair{0, 1}));
  EXPECT_THAT(pairs_of({box, {{next, 0, 0}, {2, 1, 1}}}), IsEmpty());
}

TEST(EmbreeCollider, KnowsBoxesAsFarAwayAsFloatsGo) {
  const Aabb all{{-FLT_MAX, -FLT_MAX, -FLT_MAX}, {FLT_MAX, FLT_MAX, FLT_MAX}};
  const Aabb far{{1e30F, 1e30F, 1e30F}, {2e30F, 2e30F, 2e30F}};
  const Aabb farther{{3e30F, 1e30F, 1e30F}, {4e30F, 2e30F, 2e30F}};
  EXPECT_THAT(pairs_of({all, far, farther}), ElementsAre(Pair{0, 1}, Pair{0, 2}));
}

TEST(EmbreeCollider, LeavesEmptySlotsOut) {
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_THAT(pairs_of({kNobody, box, kNobody, box}), ElementsAre(Pair{1, 3}));
  EXPECT_THAT(pairs_of({kNobody, kNobody, kNobody}), IsEmpty());
}

TEST(EmbreeCollider, AgreesWithTheOracleOnAThousandBoxesForOneThreadAndMany) {
  std::vector<Aabb> boxes;
  std::uint64_t state = 1;
  const auto next = [&] { return static_cast<float>((state = mix64(state + 1)) >> 44) * 0x1p-14F; };
  for (int i = 0; i < 1000; ++i) {
    const Aabb at{{next(), next(), next()}, {}};
    boxes.push_back({at.min, {at.min[0] + 4, at.min[1] + 4, at.min[2] + 4}});
  }
  const std::vector<Pair> expected = brute_force_pairs(boxes);
  ASSERT_GT(expected.size(), 100U);
  EXPECT_EQ(pairs_of(boxes, 1), expected);
  EXPECT_EQ(pairs_of(boxes, 4), expected);
}

}  // namespace
}  // namespace cellsweep::embree
