#include "view/painter.h"

#include <cstddef>

#include "cellsweep/world/eigen.h"
#include "view/shaders.h"

namespace cellsweep::view {
namespace {

using Eigen::Matrix4f;
using Eigen::Vector3f;

constexpr int kSunMapEdge = 2048;
constexpr int kSkyMapEdge = 256;
constexpr GLsizei kBoxVertexCount = 36;
constexpr GLsizei kEdgeVertexCount = 24;
constexpr Color kPaper = {0.912F, 0.926F, 0.940F};  // what the floor fades to
const Vector3f kToSun = Vector3f(0.30F, 0.86F, 0.42F).normalized();

template <class Instance>
void add_attribute(GLuint number, GLint floats, std::size_t offset) {
  glEnableVertexAttribArray(number);
  glVertexAttribPointer(number, floats, GL_FLOAT, GL_FALSE, sizeof(Instance),
                        // NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes an offset as a pointer.
                        reinterpret_cast<const void*>(offset));
  glVertexAttribDivisor(number, 1);
}

}  // namespace

Painter::Painter()
    : depth_({kBoxVertices}, {kNoColor}),
      boxes_({kBoxVertices}, {kLight, kBoxEdges, kBoxColor}),
      glow_({kBoxVertices}, {kWorldSize, kBoxEdges, kGlowColor}),
      floor_({kFloorVertices}, {kLight, kFloorColor}),
      lines_({kEdgeVertices}, {kLineColor}),
      sun_map_(kSunMapEdge),
      sky_map_(kSkyMapEdge) {
  glGenVertexArrays(1, &no_arrays_);
  glGenVertexArrays(1, &arrays_);
  glBindVertexArray(arrays_);
  glGenBuffers(1, &buffer_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  add_attribute<DrawnBox>(0, 3, offsetof(DrawnBox, centre));
  add_attribute<DrawnBox>(1, 3, offsetof(DrawnBox, half_extents));
  add_attribute<DrawnBox>(2, 4, offsetof(DrawnBox, orientation));
  add_attribute<DrawnBox>(3, 3, offsetof(DrawnBox, color));
  glGenVertexArrays(1, &line_arrays_);
  glBindVertexArray(line_arrays_);
  glGenBuffers(1, &line_buffer_);
  glBindBuffer(GL_ARRAY_BUFFER, line_buffer_);
  add_attribute<LineBox>(0, 3, offsetof(LineBox, min));
  add_attribute<LineBox>(1, 3, offsetof(LineBox, max));
  add_attribute<LineBox>(2, 3, offsetof(LineBox, color));
}

Painter::~Painter() {
  glDeleteBuffers(1, &line_buffer_);
  glDeleteVertexArrays(1, &line_arrays_);
  glDeleteBuffers(1, &buffer_);
  glDeleteVertexArrays(1, &arrays_);
  glDeleteVertexArrays(1, &no_arrays_);
}

void Painter::paint(const DrawnBoxes& boxes, std::span<const LineBox> lines, const Aabb& world,
                    const OrbitCamera& camera, GLuint framebuffer, const Viewport& viewport) {
  upload(boxes.all);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
  depth_.use();
  sun_map_.begin();
  draw_boxes(depth_, light_matrix(world, kToSun));
  sky_map_.begin();
  draw_boxes(depth_, light_matrix(world, Vector3f::UnitY()));

  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(viewport.left, viewport.bottom, viewport.width, viewport.height);
  glClearColor(kPaper[0], kPaper[1], kPaper[2], 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const float aspect = static_cast<float>(viewport.width) / static_cast<float>(viewport.height);
  const Matrix4f to_clip = camera.projection(aspect) * camera.view();
  // Depth first: light, which is dear, is then worked out for what is seen only.
  depth_.use();
  draw_boxes(depth_, to_clip);
  glDepthFunc(GL_LEQUAL);
  boxes_.use();
  set_light(boxes_, world);
  draw_boxes(boxes_, to_clip);
  draw_floor(world, to_clip);
  if (!lines.empty()) draw_lines(lines, to_clip);
  if (!boxes.glowing().empty()) draw_glow(boxes.glowing(), world, to_clip);
}

void Painter::upload(std::span<const DrawnBox> boxes) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(boxes.size_bytes()), boxes.data(), GL_STREAM_DRAW);
  count_ = static_cast<GLsizei>(boxes.size());
}

void Painter::draw_boxes(const GlProgram& program, const Matrix4f& to_clip) const {
  program.set("to_clip", to_clip);
  glBindVertexArray(arrays_);
  glDrawArraysInstanced(GL_TRIANGLES, 0, kBoxVertexCount, count_);
}

void Painter::set_light(const GlProgram& program, const Aabb& world) const {
  sun_map_.bind(0);
  sky_map_.bind(1);
  program.set("sun_map", 0);
  program.set("sky_map", 1);
  program.set("to_sun_map", light_matrix(world, kToSun));
  program.set("to_sky_map", light_matrix(world, Vector3f::UnitY()));
  program.set("to_sun", kToSun);
  program.set("world_size", to_eigen(world).sizes().maxCoeff());
}

// Seen through a little, so that many of them do not hide what they are around.
void Painter::draw_lines(std::span<const LineBox> lines, const Matrix4f& to_clip) const {
  glBindVertexArray(line_arrays_);
  glBindBuffer(GL_ARRAY_BUFFER, line_buffer_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(lines.size_bytes()), lines.data(), GL_STREAM_DRAW);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  lines_.use();
  lines_.set("to_clip", to_clip);
  glDrawArraysInstanced(GL_LINES, 0, kEdgeVertexCount, static_cast<GLsizei>(lines.size()));
  glDisable(GL_BLEND);
}

// Over all that was drawn, and of each other the nearest.
void Painter::draw_glow(std::span<const DrawnBox> boxes, const Aabb& world, const Matrix4f& to_clip) {
  upload(boxes);
  glClear(GL_DEPTH_BUFFER_BIT);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  depth_.use();
  draw_boxes(depth_, to_clip);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glow_.use();
  glow_.set("world_size", to_eigen(world).sizes().maxCoeff());
  draw_boxes(glow_, to_clip);
  glDisable(GL_BLEND);
}

void Painter::draw_floor(const Aabb& world, const Matrix4f& to_clip) const {
  floor_.use();
  set_light(floor_, world);
  floor_.set("to_clip", to_clip);
  floor_.set("world_min", to_eigen(world).min());
  floor_.set("world_max", to_eigen(world).max());
  glBindVertexArray(no_arrays_);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace cellsweep::view
