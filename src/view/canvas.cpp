#include "view/canvas.h"

#include <algorithm>
#include <stdexcept>

namespace cellsweep::view {
namespace {

constexpr int kSamples = 4;

GLuint make_storage(int samples, GLenum format, GLenum attachment, int width, int height) {
  GLuint storage = 0;
  glGenRenderbuffers(1, &storage);
  glBindRenderbuffer(GL_RENDERBUFFER, storage);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, storage);
  return storage;
}

}  // namespace

Canvas::Canvas(int width, int height) : width_(width), height_(height) {
  int most = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  painted_ = make_layer(std::min(kSamples, most));
  smooth_ = make_layer(0);
}

Canvas::~Canvas() {
  remove(painted_);
  remove(smooth_);
}

Canvas::Layer Canvas::make_layer(int samples) const {
  Layer layer;
  glGenFramebuffers(1, &layer.framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, layer.framebuffer);
  layer.color = make_storage(samples, GL_RGBA8, GL_COLOR_ATTACHMENT0, width_, height_);
  layer.depth = make_storage(samples, GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, width_, height_);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("the driver has no framebuffer of that size");
  return layer;
}

void Canvas::remove(const Layer& layer) {
  glDeleteFramebuffers(1, &layer.framebuffer);
  glDeleteRenderbuffers(1, &layer.color);
  glDeleteRenderbuffers(1, &layer.depth);
}

void Canvas::smooth() const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, painted_.framebuffer);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, smooth_.framebuffer);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void Canvas::show() const {
  smooth();
  glBindFramebuffer(GL_READ_FRAMEBUFFER, smooth_.framebuffer);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
  glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

report::Image Canvas::read() const {
  smooth();
  const auto row = 3 * static_cast<std::size_t>(width_);
  report::Image image{static_cast<unsigned>(width_), static_cast<unsigned>(height_), {}};
  image.rgb.resize(row * image.height);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, smooth_.framebuffer);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
  // OpenGL's rows go up.
  for (std::size_t low = 0, high = image.height - 1; low < high; ++low, --high) {
    const auto first = image.rgb.begin() + static_cast<std::ptrdiff_t>(low * row);
    const auto last = image.rgb.begin() + static_cast<std::ptrdiff_t>(high * row);
    std::swap_ranges(first, first + static_cast<std::ptrdiff_t>(row), last);
  }
  return image;
}

}  // namespace cellsweep::view
