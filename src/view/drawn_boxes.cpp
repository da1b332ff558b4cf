#include "view/drawn_boxes.h"

#include <algorithm>
#include <cmath>

#include "report/picture/picture.h"

namespace cellsweep::view {
namespace {

constexpr float kBarThickness = 0.0018F;  // in edges of the world
constexpr Color kBarColor = {0.245F, 0.283F, 0.346F};
constexpr Color kFatBoxColor = {0.02F, 0.33F, 0.72F};
constexpr Color kCellColor = {0.80F, 0.30F, 0.02F};

std::array<float, 4> unit_length(std::array<float, 4> q) {
  const float length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (float& part : q) part /= length;
  return q;
}

void add_bars(const Aabb& world, std::vector<DrawnBox>& boxes) {
  std::array<float, 3> edges{};
  for (std::size_t axis = 0; axis < 3; ++axis) edges[axis] = world.max[axis] - world.min[axis];
  const float thickness = kBarThickness * *std::max_element(edges.begin(), edges.end());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (unsigned corner = 0; corner < 4; ++corner) {
      const std::size_t one = (axis + 1) % 3;
      const std::size_t other = (axis + 2) % 3;
      DrawnBox bar{{}, {thickness, thickness, thickness}, {0, 0, 0, 1}, kBarColor};
      bar.centre[axis] = 0.5F * (world.min[axis] + world.max[axis]);
      bar.half_extents[axis] = 0.5F * edges[axis] + thickness;
      bar.centre[one] = (corner & 1) != 0 ? world.max[one] : world.min[one];
      bar.centre[other] = (corner & 2) != 0 ? world.max[other] : world.min[other];
      boxes.push_back(bar);
    }
  }
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

std::vector<DrawnBox> drawn_boxes(const Simulation& simulation) {
  const WorldColors colors;
  std::vector<DrawnBox> boxes;
  boxes.reserve(simulation.bodies() + 12);
  for (const BodyId body : report::shown_bodies(simulation.source(), simulation.bounds())) {
    const BodyPose pose = report::shown_pose(simulation.source(), body);
    boxes.push_back({pose.centre, pose.half_extents, unit_length(pose.orientation),
                     simulation.colliding()[body] ? colors.colliding : colors.plain});
  }
  add_bars(simulation.bounds(), boxes);
  return boxes;
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
