#include "view/orbit_camera.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cellsweep::view {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

const Aabb kWorld{{0, 0, 0}, {20, 20, 20}};
const Vector3f kMiddle{10, 10, 10};
constexpr float kWidth = 900;
constexpr float kHeight = 600;

Vector2f on_picture(const OrbitCamera& camera, const Vector3f& point) {
  return camera.project(point, kWidth, kHeight);
}

TEST(OrbitCamera, SeesTheWholeWorldAtFirst) {
  const OrbitCamera camera(kWorld);
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3f point(corner & 1 ? 20 : 0, corner & 2 ? 20 : 0, corner & 4 ? 20 : 0);
    const Vector2f place = on_picture(camera, point);
    EXPECT_GT(place.minCoeff(), 0) << corner;
    EXPECT_LT(place.x(), kWidth) << corner;
    EXPECT_LT(place.y(), kHeight) << corner;
  }
}

TEST(OrbitCamera, HasUpAboveAndRightAtTheRight) {
  const OrbitCamera camera(kWorld);
  const Vector2f middle = on_picture(camera, kMiddle);
  EXPECT_LT(on_picture(camera, kMiddle + Vector3f(0, 1, 0)).y(), middle.y());
  EXPECT_GT(on_picture(camera, kMiddle + Vector3f(1, 0, 0)).x(), middle.x());
  EXPECT_LT(on_picture(camera, kMiddle + Vector3f(0, 0, 1)).x(), middle.x());
}

TEST(OrbitCamera, KeepsItsDistanceWhileItTurnsAndComesBackAfterAWholeTurn) {
  OrbitCamera camera(kWorld);
  const Vector3f first = camera.eye();
  for (int part = 0; part < 8; ++part) {
    camera.orbit(static_cast<float>(EIGEN_PI / 4), 0);
    EXPECT_NEAR(camera.eye().y(), first.y(), 1e-3);
    const Eigen::Matrix3f axes = camera.view().block<3, 3>(0, 0);
    EXPECT_TRUE((axes * axes.transpose()).isIdentity(1e-4F));
    if (part < 7) {
      EXPECT_GT((camera.eye() - first).norm(), 1);
    }
  }
  EXPECT_LT((camera.eye() - first).norm(), 1e-2);
}

TEST(OrbitCamera, StopsShortOfStraightAboveAndBelow) {
  OrbitCamera camera(kWorld);
  for (int time = 0; time < 100; ++time) camera.orbit(0, 0.2F);
  EXPECT_GT(camera.eye().y(), 40);
  EXPECT_GT(on_picture(camera, {20, 10, 0}).x(), on_picture(camera, {0, 10, 20}).x());
  for (int time = 0; time < 100; ++time) camera.orbit(0, -0.2F);
  EXPECT_LT(camera.eye().y(), -20);
  EXPECT_TRUE(camera.view().allFinite());
}

TEST(OrbitCamera, ShowsThingsLargerWhenItComesNearerWithinLimits) {
  OrbitCamera camera(kWorld);
  const auto size = [&] {
    return (on_picture(camera, kMiddle) - on_picture(camera, kMiddle + Vector3f(0, 1, 0))).norm();
  };
  const float before = size();
  camera.zoom(0.5F);
  EXPECT_NEAR(size(), 2 * before, 0.2F * before);
  for (int time = 0; time < 200; ++time) camera.zoom(0.5F);
  EXPECT_TRUE(camera.projection(1.5F).allFinite());
  EXPECT_GT(camera.eye().y(), -10);
  for (int time = 0; time < 200; ++time) camera.zoom(2);
  EXPECT_LT(camera.eye().norm(), 1000);
}

TEST(OrbitCamera, ShiftsTheWorldByPartsOfThePicturesHeight) {
  OrbitCamera camera(kWorld);
  const Vector3f target = camera.eye() - camera.view().block<1, 3>(2, 0).transpose() *
                                             (0.95F * 0.5F * std::sqrt(1200.0F) / 0.25F);
  const Vector2f before = on_picture(camera, target);
  EXPECT_NEAR(before.x(), kWidth / 2, 0.1F);
  EXPECT_NEAR(before.y(), kHeight / 2, 0.1F);
  camera.pan(0.1F, 0.2F);
  const Vector2f after = on_picture(camera, target);
  EXPECT_NEAR(after.x() - before.x(), 0.1F * kHeight, 0.5F);
  EXPECT_NEAR(before.y() - after.y(), 0.2F * kHeight, 0.5F);
}

TEST(OrbitCamera, HasAllOfTheWorldBetweenItsNearAndFarPlanes) {
  OrbitCamera camera(kWorld);
  for (const float around : {0.0F, 1.0F, 2.0F, 3.0F}) {
    camera.orbit(around, -0.1F * around);
    for (int corner = 0; corner < 8; ++corner) {
      const Vector3f point(corner & 1 ? 20 : 0, corner & 2 ? 20 : 0, corner & 4 ? 20 : 0);
      const Eigen::Vector4f clip = camera.projection(1.5F) * camera.view() * point.homogeneous();
      EXPECT_LT(std::abs(clip.z()), clip.w());
    }
  }
}

TEST(OrbitCamera, LooksThroughThePointsOfItsPicture) {
  OrbitCamera camera(kWorld);
  camera.orbit(0.7F, -0.3F);
  for (const auto& [width, height] : {std::pair{kWidth, kHeight}, std::pair{300.0F, 400.0F}}) {
    for (const Vector2f& pixel : {Vector2f(0, 0), Vector2f(150, 220), Vector2f(299, 399)}) {
      const Look look = camera.look_through(pixel, width, height);
      EXPECT_EQ(look.eye, camera.eye());
      EXPECT_NEAR(look.direction.norm(), 1, 1e-5F);
      EXPECT_LT(look.direction.dot(look.back), 0);
      EXPECT_LT((camera.project(look.eye + 30 * look.direction, width, height) - pixel).norm(), 0.05F);
    }
  }
}

}  // namespace
}  // namespace cellsweep::view
