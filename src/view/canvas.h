/// @file
/// What is painted on: a smoothed picture of any size, which no other window can cover.
#pragma once

#include <epoxy/gl.h>

#include "report/picture/image.h"

namespace cellsweep::view {

/// Belongs to the context that is current when it is made, and goes before it.
class Canvas {
 public:
  /// Throws std::runtime_error when the driver has no such framebuffer.
  Canvas(int width, int height);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }

  /// The framebuffer to paint on, with four samples a pixel where the driver has them.
  GLuint framebuffer() const { return painted_.framebuffer; }

  /// Copies what was painted to the window's framebuffer, which has the same size.
  void show() const;

  /// What was painted.
  report::Image read() const;

 private:
  struct Layer {
    GLuint framebuffer = 0;
    GLuint color = 0;
    GLuint depth = 0;
  };

  Layer make_layer(int samples) const;
  static void remove(const Layer& layer);
  void smooth() const;

  int width_;
  int height_;
  Layer painted_;
  Layer smooth_;
};

}  // namespace cellsweep::view
