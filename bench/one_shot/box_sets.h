/// @file
/// The sets of boxes that are searched.
#pragma once

#include <array>
#include <string_view>

#include "bench/one_shot/searcher.h"

namespace cellsweep::bench {

/// One set: scenes. Two sets: `mixed` are a scene's bodies in turn, so that half of all pairs are wanted;
/// `touching` are two scenes side by side, of which a twentieth of the width is shared; `few` are 1,000 of a
/// scene's bodies and all others.
inline constexpr std::array<std::string_view, 3> kSetScenes = {"uniform", "clustered", "varied"};
inline constexpr std::array<std::string_view, 4> kSetKinds = {"one", "mixed", "touching", "few"};

/// Of `boxes` boxes together.
BoxSets make_box_sets(std::string_view scene, std::string_view kind, std::size_t boxes);

}  // namespace cellsweep::bench
