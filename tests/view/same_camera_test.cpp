#include <gtest/gtest.h>

#include "report/picture/camera.h"
#include "view/orbit_camera.h"

namespace cellsweep::view {
namespace {

TEST(OrbitCamera, ShowsEveryPointWhereARayTracedPictureHasIt) {
  const Aabb world{{-3, 1, 2}, {17, 9, 30}};
  for (const auto& [width, height] : {std::pair{900U, 600U}, std::pair{300U, 400U}, std::pair{2000U, 500U}}) {
    const report::Camera traced(world, width, height);
    const OrbitCamera camera(world);
    for (const Eigen::Vector2f& pixel : {Eigen::Vector2f(0, 0), Eigen::Vector2f(150, 220),
                                         Eigen::Vector2f(299, 1), Eigen::Vector2f(250, 399)}) {
      const report::Ray ray = traced.ray_through(pixel.x(), pixel.y());
      const Eigen::Vector2f place = camera.project(ray.origin + 30 * ray.direction, static_cast<float>(width),
                                                   static_cast<float>(height));
      EXPECT_LT((place - pixel).norm(), 0.05F) << pixel.transpose();
    }
  }
}

}  // namespace
}  // namespace cellsweep::view
