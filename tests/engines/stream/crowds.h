/// @file
/// Worlds made of crowds, to search among for what costs too much.
#pragma once

#include <array>
#include <cstddef>
#include <iosfwd>
#include <vector>

#include "cellsweep/aabb.h"
#include "contract/random.h"

namespace cellsweep::stream {

/// Bodies of about one size in one place, either of which may differ from axis to axis by any factor.
struct Crowd {
  float share;
  std::array<float, 3> edges;
  std::array<float, 3> spread;
  std::array<float, 3> centre;
  float decades;  ///< by which sizes differ
};

struct CrowdedWorld {
  std::vector<Crowd> crowds;
  bool smallest_first = false;  ///< or in the order of the crowds
};

void PrintTo(const CrowdedWorld& world, std::ostream* out);

float power_of_ten(contract::Random& random, float low, float high);

CrowdedWorld random_world(contract::Random& random);

/// The world with one of its numbers, or one of its crowds, another.
CrowdedWorld mutated(CrowdedWorld world, contract::Random& random);

/// `count` boxes and a few more, the same for the same world.
std::vector<Aabb> boxes_of(const CrowdedWorld& world, std::size_t count);

}  // namespace cellsweep::stream
