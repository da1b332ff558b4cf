#include "view/probe.h"

#include <algorithm>
#include <array>
#include <optional>

#include "cellsweep/world/eigen.h"
#include "view/line_span.h"

namespace cellsweep::view {
namespace {

using Eigen::Vector3f;

constexpr float kFirstEdge = 0.2F;  // of the box, in edges of the world
constexpr float kShortestEdge = 0.01F;
constexpr float kLongestEdge = 2;
constexpr float kReach = 2;  // the box's centre from the world's, in edges of the world

std::array<float, 3> numbers_of(const Vector3f& v) {
  return {v.x(), v.y(), v.z()};
}

Aabb box_around(const Vector3f& centre, const Vector3f& half) {
  return {numbers_of(centre - half), numbers_of(centre + half)};
}

Vector3f centre_of(const Aabb& box) {
  return to_eigen(box).center();
}

Ray along(const Look& look) {
  const Vector3f& d = look.direction;
  return {numbers_of(look.eye), {double{d.x()}, double{d.y()}, double{d.z()}}};
}

std::optional<double> time_of_first(const Broadphase& world, const Ray& ray) {
  const auto touch = world.queries().first_touch(ray);
  if (!touch || !*touch) return std::nullopt;
  return (*touch)->time;
}

}  // namespace

Probe::Probe(const Aabb& world)
    : world_(world), box_(box_around(centre_of(world), 0.5F * kFirstEdge * to_eigen(world).sizes())) {
  const Vector3f size = to_eigen(world).sizes();
  const Vector3f start = centre_of(world) - Vector3f(0.6F * size.x(), 0, 0);
  ray_ = {numbers_of(start), {1, 0, 0}};
  held_ = centre_of(world);
  offset_ = Vector3f::Zero();
}

void Probe::choose_next() {
  tool_ = tool_ == Tool::none ? Tool::box : tool_ == Tool::box ? Tool::ray : Tool::none;
}

void Probe::hold(const Aabb& box) {
  tool_ = Tool::box;
  box_ = box;
}

void Probe::hold(const Ray& ray) {
  tool_ = Tool::ray;
  ray_ = ray;
}

void Probe::grab(const Look& look, const Broadphase& world) {
  held_ = centre_of(box_);
  offset_ = Vector3f::Zero();
  const auto at = [&](double time) -> Vector3f {
    return look.eye + static_cast<float>(time) * look.direction;
  };
  if (const auto of_box = span_in(to_eigen(box_), look.eye, look.direction)) {
    offset_ = held_ - at(of_box->first);
    held_ = at(of_box->first);
  } else if (const auto of_body = time_of_first(world, along(look))) {
    held_ = at(*of_body);
  }
  drag(look);
}

void Probe::drag(const Look& look) {
  if (tool_ == Tool::ray) ray_ = along(look);
  if (tool_ != Tool::box) return;
  const float away = (held_ - look.eye).dot(look.back) / look.direction.dot(look.back);
  move_box_to(look.eye + away * look.direction + offset_);
}

void Probe::resize(float factor) {
  const Vector3f edges = to_eigen(world_).sizes();
  const Vector3f wanted = factor * to_eigen(box_).sizes();
  const float longest = edges.maxCoeff();
  const Vector3f half = 0.5F * wanted.cwiseMax(kShortestEdge * longest).cwiseMin(kLongestEdge * longest);
  box_ = box_around(centre_of(box_), half);
}

void Probe::move_box_to(const Vector3f& centre) {
  const float reach = kReach * to_eigen(world_).sizes().maxCoeff();
  const Vector3f middle = centre_of(world_);
  const Vector3f within = middle + (centre - middle).cwiseMax(-reach).cwiseMin(reach);
  box_ = box_around(within, 0.5F * to_eigen(box_).sizes());
}

Met met_by(const Probe& probe, const Broadphase& world) {
  Met met;
  std::vector<BodyId> inside;
  // What is refused, a box that was dragged to where floats end, meets nobody.
  if (probe.tool() == Tool::ray) static_cast<void>(world.queries().find_touches(probe.ray(), met));
  if (probe.tool() == Tool::box) static_cast<void>(world.queries().find_overlaps(probe.box(), inside));
  for (const BodyId body : inside) met.push_back({body, 0});
  return met;
}

}  // namespace cellsweep::view
