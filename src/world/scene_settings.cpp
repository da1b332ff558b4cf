#include "world/scene_settings.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "world/scene_filters.h"

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

Status check_ranges(const SceneSettings& settings) {
  if (settings.moving && !(*settings.moving >= 0 && *settings.moving <= 1)) {
    return refuse("moving is " + number_text(*settings.moving) + "; the share of moving bodies is 0 to 1.");
  }
  if (!(settings.speed >= 0 && settings.speed <= kTopSpeed)) {
    return refuse("speed is " + number_text(settings.speed) + "; the factor on speeds is 0 to 1,000,000.");
  }
  if (settings.groups > kMostGroups) {
    return refuse("groups is " + std::to_string(settings.groups) + "; a mask has bits for " +
                  std::to_string(kMostGroups) + " groups.");
  }
  if (settings.bodies > kMostBodies) {
    return refuse("bodies is " + std::to_string(settings.bodies) + "; 32-bit ids name 0 to " +
                  std::to_string(kMostBodies) + ".");
  }
  return {};
}

Status check_motion(const SceneSettings& settings, const SceneInfo& info) {
  if (settings.moving && !info.moving) {
    return refuse("moving is " + number_text(*settings.moving) + ", but who moves in scene '" +
                  settings.scene + "' is its own matter; leave moving out.");
  }
  if (settings.spinning && !info.is_world) {
    return refuse("spinning is on, but the bodies of scene '" + settings.scene +
                  "' do not turn; leave spinning out.");
  }
  return {};
}

}  // namespace

Status check_scene(const SceneSettings& settings) {
  const SceneInfo* info = find_scene(settings.scene);
  if (info == nullptr) return refuse_scene(settings.scene);
  if (Status status = check_ranges(settings); !status.ok()) return status;
  return check_motion(settings, *info);
}

double moving_share(const SceneSettings& settings) {
  if (settings.moving) return *settings.moving;
  const SceneInfo* info = find_scene(settings.scene);
  return info == nullptr ? 0 : info->moving.value_or(0);
}

std::optional<BodyId> giant_body(GiantSlot slot, std::size_t bodies) {
  if (bodies == 0) return std::nullopt;
  switch (slot) {
    case GiantSlot::first:
      return 0;
    case GiantSlot::middle:
      return static_cast<BodyId>(bodies / 2);
    case GiantSlot::last:
      return static_cast<BodyId>(bodies - 1);
    default:
      return std::nullopt;
  }
}

Aabb giant_box(const Aabb& world) {
  Aabb box = world;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float margin = 0.5F * (world.max[axis] - world.min[axis]);
    box.min[axis] -= margin;
    box.max[axis] += margin;
  }
  return box;
}

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

std::vector<BodyId> list_movers(std::size_t bodies, double share, Random& random) {
  const std::vector<bool> moves = choose_movers(bodies, share, random);
  std::vector<BodyId> movers;
  for (std::size_t i = 0; i < bodies; ++i) {
    if (moves[i]) movers.push_back(static_cast<BodyId>(i));
  }
  return movers;
}

}  // namespace cellsweep
