#include "view/gl_program.h"

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "view/shaders.h"

namespace cellsweep::view {
namespace {

using Sources = std::initializer_list<const char*>;
using Log = std::array<char, 1024>;

GLuint compile(GLenum stage, Sources parts) {
  std::vector<const char*> sources = {kVersion};
  sources.insert(sources.end(), parts.begin(), parts.end());
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, static_cast<GLsizei>(sources.size()), sources.data(), nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good != 0) return shader;
  Log log{};
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  throw std::runtime_error(std::string("the driver refuses a shader: ") + log.data());
}

}  // namespace

GlProgram::GlProgram(Sources vertex, Sources fragment) : program_(glCreateProgram()) {
  const GLuint first = compile(GL_VERTEX_SHADER, vertex);
  const GLuint second = compile(GL_FRAGMENT_SHADER, fragment);
  glAttachShader(program_, first);
  glAttachShader(program_, second);
  glLinkProgram(program_);
  glDeleteShader(first);
  glDeleteShader(second);
  GLint good = 0;
  glGetProgramiv(program_, GL_LINK_STATUS, &good);
  if (good != 0) return;
  Log log{};
  glGetProgramInfoLog(program_, static_cast<GLsizei>(log.size()), nullptr, log.data());
  throw std::runtime_error(std::string("the driver refuses a program: ") + log.data());
}

void GlProgram::set(const char* name, const Eigen::Matrix4f& value) const {
  glUniformMatrix4fv(place(name), 1, GL_FALSE, value.data());
}

void GlProgram::set(const char* name, const Eigen::Vector3f& value) const {
  glUniform3fv(place(name), 1, value.data());
}

void GlProgram::set(const char* name, float value) const {
  glUniform1f(place(name), value);
}

void GlProgram::set(const char* name, int value) const {
  glUniform1i(place(name), value);
}

}  // namespace cellsweep::view
