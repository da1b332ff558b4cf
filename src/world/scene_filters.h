/// @file
/// The filters of a scene's bodies.
#pragma once

#include <vector>

#include "cellsweep/filter.h"
#include "cellsweep/pair.h"
#include "cellsweep/world/scene.h"

namespace cellsweep {

inline constexpr unsigned kMostGroups = 32;

/// By id; none when the settings ask for none. `never_moves` says it of an id.
template <class NeverMoves>
std::vector<BodyFilter> make_filters(const SceneSettings& settings, NeverMoves&& never_moves) {
  std::vector<BodyFilter> filters;
  if (!settings.rest_is_static && settings.groups < 2) return filters;
  filters.resize(settings.bodies);
  for (std::size_t id = 0; id < filters.size(); ++id) {
    filters[id].is_static = settings.rest_is_static && never_moves(static_cast<BodyId>(id));
    if (settings.groups < 2) continue;
    filters[id].category = 1U << id % settings.groups;
    filters[id].mask = ~filters[id].category;
  }
  return filters;
}

}  // namespace cellsweep
