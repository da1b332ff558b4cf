#include "bench/one_shot/box_sets.h"

#include <algorithm>

#include "cellsweep/world/scene.h"

namespace cellsweep::bench {
namespace {

std::vector<Aabb> boxes_of(std::string_view scene, std::size_t boxes, std::uint64_t seed) {
  SceneSettings settings;
  settings.scene = scene;
  settings.bodies = boxes;
  settings.seed = seed;
  const auto source = std::move(*make_scene_frames(settings));
  const auto from = source->boxes();
  return {from.begin(), from.end()};
}

/// Moves boxes along the first axis so that they share a twentieth of it with others.
void put_beside(const std::vector<Aabb>& others, std::vector<Aabb>& boxes) {
  const auto by_min = [](const Aabb& one, const Aabb& other) { return one.min[0] < other.min[0]; };
  const auto by_max = [](const Aabb& one, const Aabb& other) { return one.max[0] < other.max[0]; };
  const float first = std::min_element(others.begin(), others.end(), by_min)->min[0];
  const float last = std::max_element(others.begin(), others.end(), by_max)->max[0];
  for (Aabb& box : boxes) {
    box.min[0] += 0.95F * (last - first);
    box.max[0] += 0.95F * (last - first);
  }
}

}  // namespace

BoxSets make_box_sets(std::string_view scene, std::string_view kind, std::size_t boxes) {
  if (kind == "touching") {
    BoxSets sets{boxes_of(scene, boxes / 2, 1), boxes_of(scene, boxes - boxes / 2, 2)};
    put_beside(sets.a, sets.b);
    return sets;
  }
  BoxSets sets{boxes_of(scene, boxes, 1), {}};
  if (kind == "one") return sets;
  const std::size_t few = kind == "few" ? std::min<std::size_t>(1000, boxes / 2) : boxes / 2;
  const std::size_t step = boxes / few;
  BoxSets cut;
  for (std::size_t i = 0; i < boxes; ++i) {
    const bool is_one = i % step == 0 && cut.a.size() < few;
    (is_one ? cut.a : cut.b).push_back(sets.a[i]);
  }
  return cut;
}

}  // namespace cellsweep::bench
