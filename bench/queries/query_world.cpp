#include "bench/queries/query_world.h"

#include <algorithm>

#include "cellsweep/query.h"
#include "cellsweep/world/scene.h"

namespace cellsweep::bench {
namespace {

SceneSettings settings_of(std::string_view name, std::size_t bodies, std::uint64_t seed) {
  SceneSettings settings;
  const bool on_ground = name == "ground";
  settings.scene = on_ground ? "stacks" : has_only_points(name) ? "uniform" : name;
  settings.bodies = on_ground ? bodies - 1 : bodies;
  settings.seed = seed;
  if (!on_ground) settings.moving = 1;
  return settings;
}

/// One unit thick, its top at height 0.
Aabb plane_below(const Aabb& bounds) {
  const float width = bounds.max[0] - bounds.min[0];
  const float depth = bounds.max[2] - bounds.min[2];
  return {{bounds.min[0] - width, -1, bounds.min[2] - depth},
          {bounds.max[0] + width, 0, bounds.max[2] + depth}};
}

Aabb center_of(const Aabb& box) {
  Point center{};
  for (std::size_t k = 0; k < 3; ++k) center[k] = 0.5F * (box.min[k] + box.max[k]);
  return box_at(center);
}

}  // namespace

QueryWorld::QueryWorld(std::string_view name, std::size_t bodies, std::uint64_t seed)
    : has_plane_(name == "ground"),
      only_points_(has_only_points(name)),
      source_(std::move(*make_scene_frames(settings_of(name, bodies, seed)))),
      bounds_(*scene_bounds(settings_of(name, bodies, seed))),
      boxes_(next_boxes()) {}

std::span<const BodyId> QueryWorld::advance(std::size_t one_of) {
  source_->advance();
  const std::vector<Aabb> next = next_boxes();
  moved_.clear();
  for (std::size_t i = one_of - 1; i < next.size(); i += one_of) {
    moved_.push_back(static_cast<BodyId>(i));
    boxes_[i] = next[i];
  }
  return moved_;
}

std::vector<Aabb> QueryWorld::next_boxes() const {
  const auto from = source_->boxes();
  std::vector<Aabb> boxes(from.size() + (has_plane_ ? 1 : 0));
  auto to = boxes.begin();
  if (has_plane_) *to++ = plane_below(bounds_);
  if (only_points_) {
    std::transform(from.begin(), from.end(), to, center_of);
  } else {
    std::copy(from.begin(), from.end(), to);
  }
  return boxes;
}

}  // namespace cellsweep::bench
