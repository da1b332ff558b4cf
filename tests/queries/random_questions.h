/// @file
/// Random questions about a world, most of them close to where an answer changes.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "cellsweep/query.h"
#include "contract/random.h"
#include "queries/reference.h"

namespace cellsweep::queries {

/// Asks for places and ways that bodies have or nearly have: their boxes, faces and corners, from corner to
/// corner, along an axis, from inside, and some far away.
class RandomQuestions {
 public:
  RandomQuestions(const Reference& world, std::uint64_t seed);

  Aabb box();
  Region region();
  Path path();
  QueryFilter filter();
  /// A distance in which some bodies are, none or infinity.
  double distance();
  std::size_t count();

 private:
  const Aabb& some_box();
  float coordinate(std::size_t axis);
  Point point();
  std::array<double, 3> direction(const Point& from);

  contract::Random random_;
  std::vector<Aabb> boxes_;
};

/// Asks every question of query.h once, and others in a batch of that size, and compares the answers with the
/// reference's.
testing::AssertionResult answers_are_right(const Queries& queries, const Reference& world, std::uint64_t seed,
                                           std::size_t batch = 3);

}  // namespace cellsweep::queries
