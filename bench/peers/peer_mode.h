/// @file
/// What happens in a frame that peers are measured in, and how many of them a row takes.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace cellsweep::bench {

enum class PeerMode {
  initial,       ///< all bodies new, every frame
  static_told,   ///< nothing moves, and the peer is told so
  static_given,  ///< nothing moves, and the peer is given all boxes again
  dyn10,         ///< 10 % of the bodies move, and the peer is given those
  dyn100         ///< all move
};

struct PeerModeInfo {
  std::string_view name;
  std::string_view title;  ///< for a person
  PeerMode mode;
  double moving;                      ///< share of the bodies
  std::array<std::size_t, 4> frames;  ///< with 1,000, 10,000, 100,000 and 1,000,000 bodies
};

inline constexpr std::array<std::size_t, 4> kPeerBodies = {1'000, 10'000, 100'000, 1'000'000};

inline constexpr std::array kPeerModes = {
    PeerModeInfo{"initial", "all new", PeerMode::initial, 0, {20, 10, 3, 1}},
    PeerModeInfo{"static_told", "static, told so", PeerMode::static_told, 0, {100, 50, 15, 5}},
    PeerModeInfo{"static_given", "static, all given again", PeerMode::static_given, 0, {100, 50, 15, 5}},
    PeerModeInfo{"dyn10", "10 % move", PeerMode::dyn10, 0.1, {100, 60, 20, 8}},
    PeerModeInfo{"dyn100", "all move", PeerMode::dyn100, 1, {60, 20, 6, 4}}};

inline constexpr std::array<std::string_view, 4> kPeerScenes = {"uniform", "varied", "clustered", "wall"};

}  // namespace cellsweep::bench
