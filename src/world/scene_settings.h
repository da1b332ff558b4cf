/// @file
/// What the settings of a scene come down to, for all scenes alike.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "cellsweep/status.h"
#include "cellsweep/world/scene.h"
#include "world/random.h"

namespace cellsweep {

/// Errors: those of make_scene_frames().
Status check_scene(const SceneSettings& settings);

/// The body whose place a giant takes, if any.
std::optional<BodyId> giant_body(GiantSlot slot, std::size_t bodies);

/// Larger than the world by half of it on each side.
Aabb giant_box(const Aabb& world);

/// Exactly round(share · bodies) of the bodies, by the head of a shuffle: those of a smaller share are among
/// those of a larger one.
std::vector<bool> choose_movers(std::size_t bodies, double share, Random& random);

/// The same as a list, ascending.
std::vector<BodyId> list_movers(std::size_t bodies, double share, Random& random);

}  // namespace cellsweep
