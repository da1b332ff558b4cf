/// @file
/// What the tests of worlds and scenes look at: boxes as bits, and pairs counted the slow way.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/pair.h"
#include "cellsweep/world/scene.h"
#include "cellsweep/world/world.h"

namespace cellsweep::test {

/// A hash of every bit of every box, in order.
inline std::uint64_t bits_hash(std::span<const Aabb> boxes) {
  std::uint64_t hash = 0;
  for (const Aabb& box : boxes) {
    for (const auto& corner : {box.min, box.max}) {
      for (const float x : corner)
        hash = mix64(hash + std::bit_cast<std::uint32_t>(x) + 0x9e3779b97f4a7c15ULL);
    }
  }
  return hash;
}

/// The scenes in which bodies are placed without regard to who moves, and all move as the settings say.
inline constexpr std::array kPlainScenes = {"uniform", "varied", "clustered", "wall", "touch", "paper"};

inline std::size_t count_pairs(std::span<const Aabb> boxes) {
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) pairs += overlap(boxes[i], boxes[j]) ? 1 : 0;
  }
  return pairs;
}

inline std::unique_ptr<FrameSource> frames_of(const SceneSettings& settings) {
  auto frames = make_scene_frames(settings);
  EXPECT_TRUE(frames.ok()) << frames.status().message;
  return std::move(*frames);
}

inline std::vector<Aabb> boxes_of(const World& world) {
  std::vector<Aabb> boxes;
  for (const RigidBody& body : world.bodies()) boxes.push_back(body.box);
  return boxes;
}

}  // namespace cellsweep::test
