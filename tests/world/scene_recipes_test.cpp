#include "world/scene_recipes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "cellsweep/pair.h"
#include "world/random.h"

namespace cellsweep {
namespace {

constexpr std::uint64_t kGamma = 0x9e3779b97f4a7c15ULL;

/// The number that mix64 takes to `z`.
std::uint64_t unmix64(std::uint64_t z) {
  z = (z ^ (z >> 31) ^ (z >> 62)) * 0x319642b2d24d8ec3ULL;
  z = (z ^ (z >> 27) ^ (z >> 54)) * 0x96de1b173f119089ULL;
  return z ^ (z >> 30) ^ (z >> 60);
}

/// A stream whose draw number `draw`, counted from 1, has all bits set: the largest unit() there is.
Random largest_at(std::uint64_t draw) {
  return Random(unmix64(~std::uint64_t{0}) - draw * kGamma);
}

const SceneRecipe& recipe_of(std::string_view name) {
  const auto recipes = scene_recipes();
  return *std::find_if(recipes.begin(), recipes.end(),
                       [&](const SceneRecipe& recipe) { return recipe.info.name == name; });
}

TEST(SceneRecipes, NoTwoShareAStreamOfRandomNumbers) {
  for (const SceneRecipe& one : scene_recipes()) {
    for (const SceneRecipe& other : scene_recipes()) {
      EXPECT_EQ(one.stream == other.stream, &one == &other) << one.info.name << ' ' << other.info.name;
    }
  }
}

TEST(SceneRecipes, ABodyAtTheVeryEndOfItsRoomIsInsideTheWorldAfterRounding) {
  ASSERT_EQ(largest_at(1).next(), ~std::uint64_t{0});
  constexpr BodyId kSheet = 17;
  for (float edge = 40; edge < 200; edge += 0.0371F) {
    // A sheet draws its thin axis and two edges; then come x, y and z.
    for (std::uint64_t axis = 0; axis < 3; ++axis) {
      Random random = largest_at(4 + axis);
      const Placement placement = recipe_of("wall").place({kSheet, edge, false}, random);
      const float end = placement.centre[axis] + 0.5F * placement.edges[axis];
      EXPECT_LE(end, edge);
      EXPECT_GT(end, edge - 0.001F) << "the draw was not at the end of the room";
    }
  }
}

}  // namespace
}  // namespace cellsweep
