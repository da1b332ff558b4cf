/// @file
/// The worlds that are asked about.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "cellsweep/pair.h"
#include "cellsweep/world/frame_source.h"

namespace cellsweep::bench {

/// `uniform`, `clustered` and `varied` are scenes; `ground` are stacks of ten cubes on a plane that is body 0
/// and three times as wide as they; `points` are the centers of the cubes of `uniform`.
inline constexpr std::array<std::string_view, 5> kQueryWorlds = {"uniform", "clustered", "varied", "ground",
                                                                 "points"};

inline constexpr std::array<std::size_t, 3> kQueryBodies = {10'000, 100'000, 1'000'000};

constexpr bool has_only_points(std::string_view world) {
  return world == "points";
}

class QueryWorld {
 public:
  QueryWorld(std::string_view name, std::size_t bodies, std::uint64_t seed);

  std::span<const Aabb> boxes() const { return boxes_; }
  /// Where bodies are, but for the plane.
  const Aabb& bounds() const { return bounds_; }
  /// Moves one of so many bodies, always the same ones, but for the plane, which is named all the same.
  /// Returns them; boxes() is the same memory.
  std::span<const BodyId> advance(std::size_t one_of = 1);

 private:
  std::vector<Aabb> next_boxes() const;

  bool has_plane_;
  bool only_points_;
  std::unique_ptr<FrameSource> source_;
  Aabb bounds_;
  std::vector<Aabb> boxes_;
  std::vector<BodyId> moved_;
};

}  // namespace cellsweep::bench
