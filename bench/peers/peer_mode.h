/// @file
/// What happens in a frame that peers are measured in, and how many of them a row takes.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace cellsweep::bench {

enum class PeerMode {
  initial,       ///< all bodies new, every frame
  static_told,   ///< nothing moves, and the peer is told so
  static_given,  ///< nothing moves, and the peer is given all boxes again
  dyn10,         ///< 10 % of the bodies move, and the peer is given those
  dyn100,        ///< all move
  own            ///< bodies move, come and go as the scene has it, and the peer is told
};

struct PeerModeInfo {
  std::string_view name;
  std::string_view title;  ///< for a person
  PeerMode mode;
  std::optional<double> moving;  ///< share of the bodies; none: the scene's own
  /// With 1,000, 10,000, 100,000 and 1,000,000 bodies. An engine that puts off work does it every 8 to 12.
  std::array<std::size_t, 4> frames;
};

/// A row of all new bodies with up to so many of them goes through so many worlds, one after the other: the
/// branches of one that comes again and again are soon known to the processor.
inline constexpr std::size_t kMostBodiesInManyWorlds = 10'000;
inline constexpr std::size_t kManyWorlds = 64;

inline constexpr std::array<std::size_t, 4> kPeerBodies = {1'000, 10'000, 100'000, 1'000'000};

/// How often peers that are compared take turns. With few bodies a turn takes a few milliseconds.
constexpr std::size_t turns_with(std::size_t bodies) {
  if (bodies <= 1'000) return 5;
  return bodies < 1'000'000 ? 3 : 1;
}

inline constexpr std::array kPeerModes = {
    PeerModeInfo{"initial", "all new", PeerMode::initial, 0, {kManyWorlds, kManyWorlds, 3, 1}},
    PeerModeInfo{"static_told", "static, told so", PeerMode::static_told, 0, {100, 50, 15, 5}},
    PeerModeInfo{"static_given", "static, all given again", PeerMode::static_given, 0, {100, 50, 15, 5}},
    PeerModeInfo{"dyn10", "10 % move", PeerMode::dyn10, 0.1, {100, 60, 24, 12}},
    PeerModeInfo{"dyn100", "all move", PeerMode::dyn100, 1, {100, 60, 24, 12}},
    PeerModeInfo{"own", "as the scene moves", PeerMode::own, std::nullopt, {100, 60, 24, 16}}};

/// First those whose bodies move as the mode says, then those that move in a way of their own.
inline constexpr std::array<std::string_view, 14> kPeerScenes = {
    "uniform",  "varied",     "clustered", "wall",  "stacks",   "pile", "level",
    "ragdolls", "open-world", "bullets",   "swarm", "sleepers", "dust", "axis"};
inline constexpr std::size_t kScenesThatMoveAsTold = 4;

/// By the scene's place in kPeerScenes.
constexpr bool moves_as_told(std::size_t scene) {
  return scene < kScenesThatMoveAsTold;
}

/// Whether a scene, by its place, has rows of this mode.
constexpr bool has_mode(std::size_t scene, PeerMode mode) {
  return mode == PeerMode::initial || moves_as_told(scene) == (mode != PeerMode::own);
}

}  // namespace cellsweep::bench
