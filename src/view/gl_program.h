/// @file
/// A linked OpenGL program, and its uniforms by name.
#pragma once

#include <epoxy/gl.h>

#include <Eigen/Geometry>
#include <initializer_list>

namespace cellsweep::view {

/// Belongs to the context that is current when it is made, and goes before it.
class GlProgram {
 public:
  /// Of parts of source, each stage's in this order behind the version line. Throws std::runtime_error with
  /// the driver's words.
  GlProgram(std::initializer_list<const char*> vertex, std::initializer_list<const char*> fragment);
  ~GlProgram() { glDeleteProgram(program_); }
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const { glUseProgram(program_); }

  /// Of the program in use. A name that its code does not use is no error.
  void set(const char* name, const Eigen::Matrix4f& value) const;
  void set(const char* name, const Eigen::Vector3f& value) const;
  void set(const char* name, float value) const;
  void set(const char* name, int value) const;

 private:
  GLint place(const char* name) const { return glGetUniformLocation(program_, name); }

  GLuint program_;
};

}  // namespace cellsweep::view
