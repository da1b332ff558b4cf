#include "cellsweep/world/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "world/random.h"
#include "world/scene_recipes.h"
#include "world/scene_settings.h"
#include "world/scenes/scripted_scene.h"

namespace cellsweep {
namespace {

/// A vector of the given length in a random direction, evenly spread: a point in the unit ball, stretched.
Eigen::Vector3f random_vector(double length, Random& random) {
  std::array<double, 3> point{};
  double square = 0;
  do {
    for (double& x : point) x = random.between(-1, 1);
    square = (point[0] * point[0] + point[1] * point[1]) + point[2] * point[2];
  } while (square > 1 || square < 1e-4);
  const double stretch = length / std::sqrt(square);
  Eigen::Vector3f vector;
  for (int axis = 0; axis < 3; ++axis) vector[axis] = static_cast<float>(point[axis] * stretch);
  return vector;
}

// The whole speed goes along the axes on which a body may move.
Eigen::Vector3f random_velocity(double speed, const std::array<bool, 3>& axes, Random& random) {
  Eigen::Vector3f free = random_vector(speed, random);
  if (axes[0] && axes[1] && axes[2]) return free;
  std::array<double, 3> kept{};
  double square = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (axes[axis]) kept[axis] = static_cast<double>(free[static_cast<Eigen::Index>(axis)]);
    square += kept[axis] * kept[axis];
  }
  const double stretch = square > 0 ? speed / std::sqrt(square) : 0;
  return {static_cast<float>(kept[0] * stretch), static_cast<float>(kept[1] * stretch),
          static_cast<float>(kept[2] * stretch)};
}

void set_in_motion(RigidBody& body, const Gait& gait, const SceneSettings& settings, Random& random) {
  constexpr double kRadiansPerFrame = 0.1;
  const Eigen::Vector3f& half = body.half_extents;
  const double shortest = 2 * static_cast<double>(std::min(half[0], std::min(half[1], half[2])));
  body.dynamic = true;
  const double share = gait.slowest_share + (1 - gait.slowest_share) * random.positive_unit();
  const double speed = gait.fastest * shortest * share * settings.speed;
  body.velocity = random_velocity(speed, gait.axes, random);
  if (!settings.spinning) return;
  const double rate = kRadiansPerFrame * random.positive_unit();
  body.angular_velocity = random_vector(rate, random);
}

RigidBody at_rest(const Placement& placement) {
  RigidBody body;
  for (int axis = 0; axis < 3; ++axis) {
    body.position[axis] = placement.centre[axis];
    body.half_extents[axis] = 0.5F * placement.edges[axis];
  }
  return body;
}

RigidBody giant_in(const Aabb& world) {
  RigidBody body;
  const Aabb box = giant_box(world);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<Eigen::Index>(axis);
    body.position[k] = 0.5F * (box.min[axis] + box.max[axis]);
    body.half_extents[k] = 0.5F * (box.max[axis] - box.min[axis]);
  }
  return body;
}

Aabb bounds_of(const SceneRecipe& recipe, std::size_t bodies) {
  const auto edge = static_cast<float>(recipe.world_edge(static_cast<double>(bodies)));
  return {{0, 0, 0}, {edge, edge, edge}};
}

double share_of_movers(const SceneRecipe& recipe, const SceneSettings& settings) {
  if (recipe.movers == nullptr || settings.bodies == 0) return moving_share(settings);
  return static_cast<double>(recipe.movers(settings.bodies)) / static_cast<double>(settings.bodies);
}

World make_world(const SceneRecipe& recipe, const SceneSettings& settings) {
  const Aabb bounds = bounds_of(recipe, settings.bodies);
  Random scene_random(settings.seed, recipe.stream);
  const std::uint64_t bodies_seed = scene_random.next();
  const double share = share_of_movers(recipe, settings);
  const std::vector<bool> moves = choose_movers(settings.bodies, share, scene_random);
  const auto giant = giant_body(settings.giant, settings.bodies);

  World world(bounds);
  for (std::size_t i = 0; i < settings.bodies; ++i) {
    // A stream for each body, its place drawn first: who else moves or spins changes nothing here.
    Random random(bodies_seed, i);
    RigidBody body = at_rest(recipe.place({static_cast<BodyId>(i), bounds.max[0], moves[i]}, random));
    if (moves[i]) set_in_motion(body, recipe.gait, settings, random);
    world.add(giant == i ? giant_in(bounds) : body);
  }
  return world;
}

}  // namespace

std::span<const SceneInfo> scene_table() {
  static const std::vector<SceneInfo> table = [] {
    std::vector<SceneInfo> infos;
    for (const SceneRecipe& recipe : scene_recipes()) infos.push_back(recipe.info);
    for (const ScriptedScene& scene : scripted_scenes()) infos.push_back(scene.info);
    return infos;
  }();
  return table;
}

const SceneInfo* find_scene(std::string_view name) {
  const auto table = scene_table();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const SceneInfo& info) { return info.name == name; });
  return found == table.end() ? nullptr : &*found;
}

Result<World> make_scene(const SceneSettings& settings) {
  if (Status status = check_scene(settings); !status.ok()) return status;
  if (const SceneRecipe* recipe = find_recipe(settings.scene)) return make_world(*recipe, settings);
  return Status::bad_option({}, "Scene '" + settings.scene +
                                    "' is no world of rigid bodies: its bodies follow a script, and only its "
                                    "frames can be had (make_scene_frames).");
}

Result<Aabb> scene_bounds(const SceneSettings& settings) {
  if (Status status = check_scene(settings); !status.ok()) return status;
  if (const SceneRecipe* recipe = find_recipe(settings.scene)) return bounds_of(*recipe, settings.bodies);
  return make_script(settings)->bounds();
}

}  // namespace cellsweep
