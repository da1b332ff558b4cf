#include "view/depth_map.h"

#include <cmath>

#include "cellsweep/world/eigen.h"

namespace cellsweep::view {

DepthMap::DepthMap(int edge) : edge_(edge) {
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, edge, edge, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  // Beyond its edge nothing is in the way of light.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  const float far[4] = {1, 1, 1, 1};
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, far);
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture_, 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
}

DepthMap::~DepthMap() {
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteTextures(1, &texture_);
}

void DepthMap::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, edge_, edge_);
  glClear(GL_DEPTH_BUFFER_BIT);
}

void DepthMap::bind(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture_);
}

Eigen::Matrix4f light_matrix(const Aabb& world, const Eigen::Vector3f& to_light) {
  const Eigen::AlignedBox3f bounds = to_eigen(world);
  const Eigen::Vector3f helper =
      std::fabs(to_light.x()) < 0.6F ? Eigen::Vector3f::UnitX() : Eigen::Vector3f::UnitZ();
  Eigen::Matrix3f axes;
  axes.row(0) = to_light.cross(helper).normalized().transpose();
  axes.row(2) = to_light.transpose();
  axes.row(1) = to_light.cross(axes.row(0).transpose()).transpose();
  const float reach = 0.525F * bounds.diagonal().norm();
  Eigen::Matrix4f matrix = Eigen::Matrix4f::Identity();
  matrix.block<3, 3>(0, 0) = axes / reach;
  matrix.row(2) = -matrix.row(2);
  matrix.block<3, 1>(0, 3) = -matrix.block<3, 3>(0, 0) * bounds.center();
  return matrix;
}

}  // namespace cellsweep::view
