#include "cellsweep/world/world.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string>

namespace cellsweep {
namespace {

/// W3. A body that is bigger than the world is past both planes of an axis: it turns back every frame and
/// stays where it is to within one step.
void turn_back(RigidBody& body, const Aabb& bounds) {
  for (int axis = 0; axis < 3; ++axis) {
    float& velocity = body.velocity[axis];
    const bool leaves_low = body.box.min[axis] < bounds.min[axis] && velocity < 0;
    const bool leaves_high = body.box.max[axis] > bounds.max[axis] && velocity > 0;
    if (leaves_low || leaves_high) velocity = -velocity;
  }
}

/// q += ½ ω q, then back to unit length: one step of Euler's method, written out because Eigen's products and
/// norms add in an order that depends on the machine's vectors.
void turn(Eigen::Quaternionf& q, const Eigen::Vector3f& angular_velocity) {
  const float a = 0.5F * angular_velocity[0];
  const float b = 0.5F * angular_velocity[1];
  const float c = 0.5F * angular_velocity[2];
  const float w = q.w() - ((a * q.x() + b * q.y()) + c * q.z());
  const float x = q.x() + ((a * q.w() + b * q.z()) - c * q.y());
  const float y = q.y() + ((b * q.w() + c * q.x()) - a * q.z());
  const float z = q.z() + ((c * q.w() + a * q.y()) - b * q.x());
  const float length = std::sqrt(((x * x + y * y) + z * z) + w * w);
  q.x() = x / length;
  q.y() = y / length;
  q.z() = z / length;
  q.w() = w / length;
}

bool is_spinning(const RigidBody& body) {
  const Eigen::Vector3f& rate = body.angular_velocity;
  return rate[0] != 0 || rate[1] != 0 || rate[2] != 0;
}

/// Moves a body by one frame; true when a bit of its box changed.
bool advance(RigidBody& body, const Aabb& bounds) {
  const Aabb before = body.box;
  turn_back(body, bounds);
  for (int axis = 0; axis < 3; ++axis) body.position[axis] += body.velocity[axis];
  if (is_spinning(body)) turn(body.orientation, body.angular_velocity);
  body.update_box();
  using Bits = std::array<std::uint32_t, 6>;
  return std::bit_cast<Bits>(before) != std::bit_cast<Bits>(body.box);
}

}  // namespace

World::World(const Aabb& bounds, const WorldColors& colors) : bounds_(bounds), colors_(colors) {}

BodyId World::add(const RigidBody& body) {
  RigidBody& added = bodies_.emplace_back(body);
  added.color = colors_.plain;
  added.update_box();
  ids_.push_back(next_id_);
  return next_id_++;
}

Status World::remove(BodyId id) {
  const std::size_t index = index_of(id);
  if (index == size()) {
    return Status::bad_bodies(StatusCode::unknown_body,
                              "The world has no body " + std::to_string(id) + " to remove.", {&id, 1});
  }
  const auto offset = static_cast<std::ptrdiff_t>(index);
  ids_.erase(ids_.begin() + offset);
  bodies_.erase(bodies_.begin() + offset);
  const auto moved = std::lower_bound(moved_.begin(), moved_.end(), id);
  if (moved != moved_.end() && *moved == id) moved_.erase(moved);
  return {};
}

RigidBody* World::find(BodyId id) {
  const std::size_t index = index_of(id);
  return index == size() ? nullptr : &bodies_[index];
}

const RigidBody* World::find(BodyId id) const {
  const std::size_t index = index_of(id);
  return index == size() ? nullptr : &bodies_[index];
}

void World::step() {
  moved_.clear();
  for (std::size_t index = 0; index < bodies_.size(); ++index) {
    if (bodies_[index].dynamic && advance(bodies_[index], bounds_)) moved_.push_back(ids_[index]);
  }
}

void World::color_collisions(std::span<const Pair> pairs) {
  for (RigidBody& body : bodies_) body.color = colors_.plain;
  for (const Pair& pair : pairs) {
    for (const BodyId id : {pair.a, pair.b}) {
      if (RigidBody* body = find(id)) body->color = colors_.colliding;
    }
  }
}

/// The place of a body, or size() when there is none of that id.
std::size_t World::index_of(BodyId id) const {
  // As long as nothing was removed, a body's place is its id.
  if (id < size() && ids_[id] == id) return id;
  const auto found = std::lower_bound(ids_.begin(), ids_.end(), id);
  return found != ids_.end() && *found == id ? static_cast<std::size_t>(found - ids_.begin()) : size();
}

}  // namespace cellsweep
