#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "cellsweep/world/world.h"
#include "world/random.h"

namespace cellsweep {
namespace {

Eigen::Vector3f random_vector(double low, double high, Random& random) {
  Eigen::Vector3f vector;
  for (int axis = 0; axis < 3; ++axis) vector[axis] = static_cast<float>(random.between(low, high));
  return vector;
}

Eigen::Quaternionf random_orientation(Random& random) {
  Eigen::Quaternionf q;
  for (int i = 0; i < 4; ++i) q.coeffs()[i] = static_cast<float>(random.between(-1, 1));
  return q.normalized();
}

/// The bounds of the body's eight corners, in double precision.
Eigen::AlignedBox3d bounds_of_corners(const RigidBody& body) {
  const Eigen::Quaterniond turned = body.orientation.cast<double>().normalized();
  const Eigen::Vector3d half = body.half_extents.cast<double>();
  Eigen::AlignedBox3d bounds;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                               (corner & 4) != 0 ? 1 : -1);
    bounds.extend(body.position.cast<double>() + turned * sign.cwiseProduct(half));
  }
  return bounds;
}

TEST(RigidBody, OneThatIsNotTurnedHasABoxOfExactlyItsHalfExtents) {
  Random random(1);
  for (int trial = 0; trial < 1000; ++trial) {
    RigidBody body;
    body.position = random_vector(-100, 100, random);
    body.half_extents = random_vector(0.001, 30, random);
    body.update_box();
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(body.box.min[axis], body.position[axis] - body.half_extents[axis]);
      EXPECT_EQ(body.box.max[axis], body.position[axis] + body.half_extents[axis]);
    }
  }
}

TEST(RigidBody, ATurnedOnesBoxEnclosesItsEightCornersAndNoMore) {
  Random random(2);
  for (int trial = 0; trial < 5000; ++trial) {
    RigidBody body;
    body.position = random_vector(-100, 100, random);
    body.half_extents = random_vector(0.001, 30, random);
    body.orientation = random_orientation(random);
    body.update_box();
    const Eigen::AlignedBox3d corners = bounds_of_corners(body);
    const double size = 30 * std::sqrt(3.0) + 100;
    const double rounding = 4 * size * 0x1p-23;
    for (int axis = 0; axis < 3; ++axis) {
      ASSERT_NEAR(body.box.min[axis], corners.min()[axis], rounding) << "trial " << trial << " axis " << axis;
      ASSERT_NEAR(body.box.max[axis], corners.max()[axis], rounding) << "trial " << trial << " axis " << axis;
    }
  }
}

TEST(RigidBody, ACubeOnItsEdgeIsWiderByTheRootOfTwo) {
  RigidBody body;
  body.orientation = Eigen::AngleAxisf(std::acos(-1.0F) / 4, Eigen::Vector3f::UnitZ());
  body.update_box();
  EXPECT_NEAR(body.box.max[0], std::sqrt(0.5F), 1e-6F);
  EXPECT_NEAR(body.box.max[1], std::sqrt(0.5F), 1e-6F);
  EXPECT_EQ(body.box.max[2], 0.5F);
}

TEST(RigidBody, TheLengthOfItsQuaternionDoesNotMatter) {
  Random random(3);
  for (int trial = 0; trial < 100; ++trial) {
    RigidBody body;
    body.half_extents = random_vector(0.1, 3, random);
    body.orientation = random_orientation(random);
    body.update_box();
    const Aabb unit_length = body.box;
    body.orientation.coeffs() *= 4.0F;
    body.update_box();
    EXPECT_EQ(body.box, unit_length);
  }
}

}  // namespace
}  // namespace cellsweep
