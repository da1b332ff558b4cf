#include "ranks/rank_scene.h"

namespace cellsweep::ranks_bench {

RankScene::RankScene(const SceneSettings& settings) {
  const auto world = make_scene(settings);
  room_ = world->bounds();
  for (const RigidBody& body : world->bodies()) {
    Aabb box;
    Point velocity;
    for (int axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<std::size_t>(axis);
      box.min[at] = body.position[axis] - body.half_extents[axis];
      box.max[at] = body.position[axis] + body.half_extents[axis];
      velocity[at] = body.dynamic ? body.velocity[axis] : 0;
    }
    boxes_.push_back(box);
    velocities_.push_back(velocity);
  }
}

bool RankScene::moves(GlobalId id) const {
  return velocities_[id] != Point{};
}

void RankScene::set_flight(GlobalId id, const Flight& flight) {
  boxes_[id] = flight.box;
  velocities_[id] = flight.velocity;
}

void RankScene::move(std::span<const GlobalId> ids, std::vector<Aabb>& moved) {
  moved.clear();
  for (const GlobalId id : ids) {
    Aabb& box = boxes_[id];
    Point& velocity = velocities_[id];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] += velocity[axis];
      box.max[axis] += velocity[axis];
      if ((box.min[axis] < room_.min[axis] && velocity[axis] < 0) ||
          (box.max[axis] > room_.max[axis] && velocity[axis] > 0))
        velocity[axis] = -velocity[axis];
    }
    moved.push_back(box);
  }
}

}  // namespace cellsweep::ranks_bench
