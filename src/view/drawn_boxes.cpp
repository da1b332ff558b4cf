#include "view/drawn_boxes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "cellsweep/world/eigen.h"
#include "report/picture/picture.h"
#include "view/line_span.h"

namespace cellsweep::view {
namespace {

using Eigen::Vector3f;

constexpr float kBarThickness = 0.0018F;  // in edges of the world
constexpr Color kBarColor = {0.245F, 0.283F, 0.346F};
constexpr float kToolBars = 1.6F;    // as thick as the world's
constexpr float kRayBeyond = 0.15F;  // how far a ray is seen around the world, in edges of the world
constexpr Color kToolColor = {0.62F, 0.05F, 0.42F};
constexpr Color kMetColor = {0.95F, 0.50F, 0.06F};
constexpr Color kFirstColor = {1.0F, 0.92F, 0.12F};
constexpr Color kFatBoxColor = {0.02F, 0.33F, 0.72F};
constexpr Color kCellColor = {0.80F, 0.30F, 0.02F};

std::array<float, 4> unit_length(std::array<float, 4> q) {
  const float length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (float& part : q) part /= length;
  return q;
}

float bar_thickness(const Aabb& world) {
  return kBarThickness * to_eigen(world).sizes().maxCoeff();
}

void add_bars(const Aabb& box, float thickness, const Color& color, std::vector<DrawnBox>& boxes) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (unsigned corner = 0; corner < 4; ++corner) {
      const std::size_t one = (axis + 1) % 3;
      const std::size_t other = (axis + 2) % 3;
      DrawnBox bar{{}, {thickness, thickness, thickness}, {0, 0, 0, 1}, color};
      bar.centre[axis] = 0.5F * (box.min[axis] + box.max[axis]);
      bar.half_extents[axis] = 0.5F * (box.max[axis] - box.min[axis]) + thickness;
      bar.centre[one] = (corner & 1) != 0 ? box.max[one] : box.min[one];
      bar.centre[other] = (corner & 2) != 0 ? box.max[other] : box.min[other];
      boxes.push_back(bar);
    }
  }
}

// The part of it that is near the world: it may begin far away, and never ends.
void add_ray(const Ray& ray, const Aabb& world, std::vector<DrawnBox>& boxes) {
  const Vector3f origin(ray.origin[0], ray.origin[1], ray.origin[2]);
  const Vector3f direction =
      Eigen::Vector3d(ray.direction[0], ray.direction[1], ray.direction[2]).normalized().cast<float>();
  Eigen::AlignedBox3f around = to_eigen(world);
  const float edge = around.sizes().maxCoeff();
  around.min().array() -= kRayBeyond * edge;
  around.max().array() += kRayBeyond * edge;
  const auto span = span_in(around, origin, direction);
  if (!span) return;
  const Vector3f centre = origin + 0.5F * (span->first + span->last) * direction;
  const auto turn = Eigen::Quaternionf::FromTwoVectors(Vector3f::UnitX(), direction);
  const float thickness = kToolBars * bar_thickness(world);
  boxes.push_back({{centre.x(), centre.y(), centre.z()},
                   {0.5F * (span->last - span->first), thickness, thickness},
                   {turn.x(), turn.y(), turn.z(), turn.w()},
                   kToolColor});
}

void add_tool(const Probe& probe, const Aabb& world, std::vector<DrawnBox>& boxes) {
  if (probe.tool() == Tool::box) add_bars(probe.box(), kToolBars * bar_thickness(world), kToolColor, boxes);
  if (probe.tool() == Tool::ray) add_ray(probe.ray(), world, boxes);
}

/// By body: the colour of one that is met, nothing of the others.
std::vector<std::optional<Color>> glow_colors(const Simulation& simulation, const Probe& probe,
                                              const Met& met) {
  std::vector<std::optional<Color>> colors(simulation.bodies());
  for (const Touch& touch : met) colors[touch.body] = kMetColor;
  if (probe.tool() == Tool::ray && !met.empty()) colors[met.front().body] = kFirstColor;
  return colors;
}

// Cells at the rim of a grid may reach as far as floats do.
LineBox cut_to(const Aabb& world, const Aabb& box, const Color& color) {
  LineBox line{{}, {}, color};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float beyond = 0.25F * (world.max[axis] - world.min[axis]);
    line.min[axis] = std::clamp(box.min[axis], world.min[axis] - beyond, world.max[axis] + beyond);
    line.max[axis] = std::clamp(box.max[axis], world.min[axis] - beyond, world.max[axis] + beyond);
  }
  return line;
}

void add_lines(const std::vector<Aabb>& boxes, const Aabb& world, const Color& color,
               std::vector<LineBox>& lines) {
  for (const Aabb& box : boxes) lines.push_back(cut_to(world, box, color));
}

}  // namespace

DrawnBoxes drawn_boxes(const Simulation& simulation, const Probe& probe, const Met& met) {
  constexpr std::size_t kMostBars = 24;
  const WorldColors colors;
  const auto glow = glow_colors(simulation, probe, met);
  const Aabb& world = simulation.bounds();
  std::vector<DrawnBox> boxes;
  std::vector<DrawnBox> glowing;
  boxes.reserve(simulation.bodies() + kMostBars);
  for (const BodyId body : report::shown_bodies(simulation.source(), world)) {
    const BodyPose pose = report::shown_pose(simulation.source(), body);
    const Color& own = simulation.colliding()[body] ? colors.colliding : colors.plain;
    (glow[body] ? glowing : boxes)
        .push_back({pose.centre, pose.half_extents, unit_length(pose.orientation), glow[body].value_or(own)});
  }
  add_bars(world, bar_thickness(world), kBarColor, boxes);
  const std::size_t first_glowing = boxes.size();
  boxes.insert(boxes.end(), glowing.begin(), glowing.end());
  add_tool(probe, world, boxes);
  return {std::move(boxes), first_glowing};
}

std::vector<LineBox> line_boxes(const Simulation& simulation, const StreamParts& parts) {
  std::vector<LineBox> lines;
  if (!parts.fat_boxes && !parts.cells) return lines;
  const auto view = simulation.stream_view();
  if (!view) return lines;
  if (parts.fat_boxes) add_lines(view->fat_boxes, simulation.bounds(), kFatBoxColor, lines);
  if (parts.cells) add_lines(view->cells, simulation.bounds(), kCellColor, lines);
  return lines;
}

}  // namespace cellsweep::view
