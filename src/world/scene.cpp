#include "cellsweep/world/scene.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "world/random.h"
#include "world/scene_recipes.h"

namespace cellsweep {
namespace {

constexpr std::uint64_t kMostBodies = std::uint64_t{1} << 32;
constexpr double kTopSpeed = 1e6;

std::string number_text(double number) {
  std::array<char, 32> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr};
}

Status refuse(std::string message) {
  return Status::bad_option({}, std::move(message));
}

Status refuse_scene(const std::string& name) {
  std::string message = "There is no scene '" + name + "'; there are";
  const char* separator = " ";
  for (const SceneInfo& info : scene_table()) {
    message.append(separator).append(info.name);
    separator = ", ";
  }
  return refuse(message + ".");
}

Status check(const SceneSettings& settings) {
  if (!(settings.moving >= 0 && settings.moving <= 1)) {
    return refuse("moving is " + number_text(settings.moving) + "; the share of moving bodies is 0 to 1.");
  }
  if (!(settings.speed >= 0 && settings.speed <= kTopSpeed)) {
    return refuse("speed is " + number_text(settings.speed) + "; the factor on speeds is 0 to 1,000,000.");
  }
  if (settings.bodies > kMostBodies) {
    return refuse("bodies is " + std::to_string(settings.bodies) + "; 32-bit ids name 0 to " +
                  std::to_string(kMostBodies) + ".");
  }
  return {};
}

const SceneRecipe* find_recipe(std::string_view name) {
  const auto recipes = scene_recipes();
  const auto found = std::find_if(recipes.begin(), recipes.end(),
                                  [&](const SceneRecipe& recipe) { return recipe.info.name == name; });
  return found == recipes.end() ? nullptr : &*found;
}

/// Exactly round(share · bodies) of the bodies, by the head of a shuffle: those of a smaller share are among
/// those of a larger one.
std::vector<bool> choose_movers(std::size_t bodies, double share, Random& random) {
  const auto wanted = static_cast<std::size_t>(std::llround(share * static_cast<double>(bodies)));
  std::vector<BodyId> deck(bodies);
  for (std::size_t i = 0; i < bodies; ++i) deck[i] = static_cast<BodyId>(i);
  std::vector<bool> moves(bodies, false);
  for (std::size_t i = 0; i < wanted; ++i) {
    std::swap(deck[i], deck[i + random.below(bodies - i)]);
    moves[deck[i]] = true;
  }
  return moves;
}

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

void set_in_motion(RigidBody& body, const SceneSettings& settings, Random& random) {
  constexpr double kEdgesPerFrame = 0.1;
  constexpr double kRadiansPerFrame = 0.1;
  const Eigen::Vector3f& half = body.half_extents;
  const double shortest = 2 * static_cast<double>(std::min(half[0], std::min(half[1], half[2])));
  body.dynamic = true;
  const double speed = kEdgesPerFrame * shortest * random.positive_unit() * settings.speed;
  body.velocity = random_vector(speed, random);
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

}  // namespace

std::span<const SceneInfo> scene_table() {
  static const std::vector<SceneInfo> table = [] {
    std::vector<SceneInfo> infos;
    for (const SceneRecipe& recipe : scene_recipes()) infos.push_back(recipe.info);
    return infos;
  }();
  return table;
}

Result<World> make_scene(const SceneSettings& settings) {
  const SceneRecipe* recipe = find_recipe(settings.scene);
  if (recipe == nullptr) return refuse_scene(settings.scene);
  if (Status status = check(settings); !status.ok()) return status;

  const auto edge = static_cast<float>(recipe->world_edge(static_cast<double>(settings.bodies)));
  Random scene_random(settings.seed, recipe->stream);
  const std::uint64_t bodies_seed = scene_random.next();
  const std::vector<bool> moves = choose_movers(settings.bodies, settings.moving, scene_random);

  World world(Aabb{{0, 0, 0}, {edge, edge, edge}});
  for (std::size_t i = 0; i < settings.bodies; ++i) {
    // A stream for each body, its place drawn first: who else moves or spins changes nothing here.
    Random random(bodies_seed, i);
    RigidBody body = at_rest(recipe->place(static_cast<BodyId>(i), edge, random));
    if (moves[i]) set_in_motion(body, settings, random);
    world.add(body);
  }
  return world;
}

}  // namespace cellsweep
