/// @file
/// Worlds for the tests of engine `stream`: boxes by the thousand, and the truth about them.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "cellsweep/broadphase.h"
#include "contract/random.h"

namespace cellsweep::stream {

#ifdef CELLSWEEP_SANITIZED_TESTS
inline constexpr std::size_t kScale = 8;  // sanitized tests are that much smaller
#else
inline constexpr std::size_t kScale = 1;
#endif

/// Ids 0 … count − 1.
std::vector<BodyId> ids_below(std::size_t count);

/// A cube of this edge anywhere in a world of that edge.
Aabb cube_in(contract::Random& random, float edge, float world);

/// Unit cubes, about one overlap for each, as in scene `uniform`.
std::vector<Aabb> uniform_boxes(std::size_t count, std::uint64_t seed);

/// Every box a little further, in a direction of its own.
void shake(std::vector<Aabb>& boxes, float step, std::uint64_t seed);

/// A broadphase that holds these boxes as bodies 0, 1, 2 …, before its first update.
Broadphase engine_with(const std::vector<Aabb>& boxes, const StreamOptions& options = {});

/// Inserts boxes as bodies 0, 1, 2 … into an empty broadphase.
void insert_all(Broadphase& engine, const std::vector<Aabb>& boxes);

/// Moves all bodies that `every` divides to the boxes of `boxes`; all when it is 1.
void move_every(Broadphase& engine, const std::vector<Aabb>& boxes, std::size_t every);

/// All pairs of these boxes by number, ascending, without any engine.
std::vector<Pair> pairs_among(const std::vector<Aabb>& boxes);

/// Success when the engine's pairs are those of brute force.
testing::AssertionResult is_exact(const Broadphase& engine, const std::vector<Aabb>& boxes);

/// The value of a counter of the engine's statistics; fails the test when there is none of that name.
std::uint64_t counter(const Broadphase& engine, std::string_view name);

}  // namespace cellsweep::stream
