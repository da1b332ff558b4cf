#include "engines/stream/crowds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>
#include <utility>

namespace cellsweep::stream {

using contract::Random;

void PrintTo(const CrowdedWorld& world, std::ostream* out) {
  for (const Crowd& crowd : world.crowds) {
    *out << "{" << crowd.share << "F, ";
    for (const auto& numbers : {crowd.edges, crowd.spread, crowd.centre})
      *out << "{" << numbers[0] << "F, " << numbers[1] << "F, " << numbers[2] << "F}, ";
    *out << crowd.decades << "F}, ";
  }
  *out << (world.smallest_first ? "smallest first" : "in order");
}

float power_of_ten(Random& random, float low, float high) {
  return std::pow(10.0F, random.between(low, high));
}

namespace {

Crowd random_crowd(Random& random) {
  Crowd crowd{power_of_ten(random, -4, 0), {}, {}, {}, random.between(0, 3)};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    crowd.edges[axis] = power_of_ten(random, -3, 2.5F);
    crowd.spread[axis] = power_of_ten(random, -3, 3);
    crowd.centre[axis] = random.between(-1, 1) * power_of_ten(random, -1, 3);
  }
  return crowd;
}

}  // namespace

CrowdedWorld random_world(Random& random) {
  CrowdedWorld world;
  for (int i = random.whole(1, 3); i > 0; --i) world.crowds.push_back(random_crowd(random));
  return world;
}

CrowdedWorld mutated(CrowdedWorld world, Random& random) {
  Crowd& crowd = world.crowds[random.below(world.crowds.size())];
  switch (random.below(6)) {
    case 0:
      if (world.crowds.size() < 4) world.crowds.push_back(random_crowd(random));
      break;
    case 1:
      if (world.crowds.size() > 1) world.crowds.pop_back();
      break;
    case 2:
      crowd.share *= power_of_ten(random, -0.5F, 0.5F);
      break;
    case 3:
      crowd.edges[random.below(3)] *= power_of_ten(random, -1, 1);
      break;
    case 4:
      crowd.spread[random.below(3)] *= power_of_ten(random, -1, 1);
      break;
    default:
      crowd.decades = random.between(0, 3);
      world.smallest_first = random.one_in(2);
  }
  return world;
}

std::vector<Aabb> boxes_of(const CrowdedWorld& world, std::size_t count) {
  Random random(7);
  float shares = 0;
  for (const Crowd& crowd : world.crowds) shares += crowd.share;
  std::vector<Aabb> boxes;
  for (const Crowd& crowd : world.crowds) {
    const auto bodies = static_cast<std::size_t>(static_cast<float>(count) * crowd.share / shares) + 1;
    for (std::size_t i = 0; i < bodies; ++i) {
      const float factor = power_of_ten(random, -crowd.decades, 0);
      Aabb box;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.min[axis] = crowd.centre[axis] + random.between(-1, 1) * crowd.spread[axis];
        box.max[axis] = box.min[axis] + crowd.edges[axis] * factor;
      }
      boxes.push_back(box);
    }
  }
  const auto size = [](const Aabb& box) { return box.max[0] - box.min[0]; };
  if (world.smallest_first)
    std::ranges::sort(boxes, [&](const Aabb& one, const Aabb& other) { return size(one) < size(other); });
  return boxes;
}

}  // namespace cellsweep::stream
