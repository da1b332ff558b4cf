/// @file
/// Draws boxes in their world with OpenGL 3.3: sun, shadows, floor; all boxes in one call, and all that are
/// only edges in another.
#pragma once

#include <span>

#include "view/depth_map.h"
#include "view/drawn_boxes.h"
#include "view/gl_program.h"
#include "view/orbit_camera.h"

namespace cellsweep::view {

/// A part of the framebuffer, in pixels from its lower left corner.
struct Viewport {
  int left = 0;
  int bottom = 0;
  int width = 0;
  int height = 0;
};

/// Belongs to the context that is current when it is made, and goes before it.
class Painter {
 public:
  /// Throws std::runtime_error when the driver refuses a program.
  Painter();
  ~Painter();
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  /// Paints over all of `framebuffer`, the world into the part `viewport`.
  void paint(const DrawnBoxes& boxes, std::span<const LineBox> lines, const Aabb& world,
             const OrbitCamera& camera, GLuint framebuffer, const Viewport& viewport);

 private:
  void upload(std::span<const DrawnBox> boxes);
  void draw_boxes(const GlProgram& program, const Eigen::Matrix4f& to_clip) const;
  void set_light(const GlProgram& program, const Aabb& world) const;
  void draw_lines(std::span<const LineBox> lines, const Eigen::Matrix4f& to_clip) const;
  void draw_glow(std::span<const DrawnBox> boxes, const Aabb& world, const Eigen::Matrix4f& to_clip);
  void draw_floor(const Aabb& world, const Eigen::Matrix4f& to_clip) const;

  GlProgram depth_;
  GlProgram boxes_;
  GlProgram glow_;
  GlProgram floor_;
  GlProgram lines_;
  DepthMap sun_map_;
  DepthMap sky_map_;
  GLuint arrays_ = 0;
  GLuint no_arrays_ = 0;
  GLuint buffer_ = 0;
  GLuint line_arrays_ = 0;
  GLuint line_buffer_ = 0;
  GLsizei count_ = 0;
};

}  // namespace cellsweep::view
