#include "view/probe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "cellsweep/world/eigen.h"
#include "view/drawn_boxes.h"
#include "view/line_span.h"

namespace cellsweep::view {
namespace {

using Eigen::Vector3f;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

const Aabb kRoom{{0, 0, 0}, {20, 20, 20}};

/// Bodies 3 and 5, one behind the other on the axis z.
Broadphase two_bodies() {
  Broadphase world;
  EXPECT_TRUE(world.insert(3, {{9, 9, 14}, {11, 11, 16}}).ok());
  EXPECT_TRUE(world.insert(5, {{9, 9, 4}, {11, 11, 6}}).ok());
  EXPECT_TRUE(world.update().ok());
  return world;
}

/// From far in front along the axis z, through a point of the plane z = 0 of the world.
Look look_at(float x, float y) {
  const Vector3f eye(10, 10, 100);
  return {eye, (Vector3f(x, y, 0) - eye).normalized(), Vector3f::UnitZ()};
}

Vector3f centre(const Probe& probe) {
  return to_eigen(probe.box()).center();
}

TEST(Probe, IsNothingABoxARayAndNothingAgain) {
  Probe probe(kRoom);
  EXPECT_EQ(probe.tool(), Tool::none);
  probe.choose_next();
  EXPECT_EQ(probe.tool(), Tool::box);
  probe.choose_next();
  EXPECT_EQ(probe.tool(), Tool::ray);
  probe.choose_next();
  EXPECT_EQ(probe.tool(), Tool::none);
}

TEST(Probe, IsInTheMiddleOfTheWorldAtFirst) {
  const Broadphase world = two_bodies();
  Probe probe(kRoom);
  EXPECT_THAT(met_by(probe, world), IsEmpty()) << "no tool meets nobody";
  probe.choose(Tool::box);
  EXPECT_EQ(probe.box(), (Aabb{{8, 8, 8}, {12, 12, 12}}));
  EXPECT_THAT(met_by(probe, world), IsEmpty());
  probe.choose(Tool::ray);
  EXPECT_EQ(probe.ray().origin, (Point{-2, 10, 10}));
}

TEST(Probe, MeetsWhatOverlapsItsBoxAndWhatItsRayTouches) {
  const Broadphase world = two_bodies();
  Probe probe(kRoom);
  probe.hold(Aabb{{11, 11, 0}, {12, 12, 20}});
  EXPECT_THAT(met_by(probe, world), ElementsAre(Touch{3, 0}, Touch{5, 0}));
  probe.hold(Ray{{10, 10, 0}, {0, 0, 2}});
  EXPECT_EQ(probe.tool(), Tool::ray);
  EXPECT_THAT(met_by(probe, world), ElementsAre(Touch{5, 2}, Touch{3, 7}));
}

TEST(Probe, ARayGoesAlongTheLook) {
  const Broadphase world = two_bodies();
  Probe probe(kRoom);
  probe.choose(Tool::ray);
  probe.grab(look_at(10, 10), world);
  EXPECT_EQ(probe.ray().origin, (Point{10, 10, 100}));
  EXPECT_THAT(met_by(probe, world), ElementsAre(Touch{3, 84}, Touch{5, 94}));
  probe.drag(look_at(0, 10));
  EXPECT_THAT(met_by(probe, world), IsEmpty()) << "it passes both at their side";
  EXPECT_LT(probe.ray().direction[0], 0);
}

TEST(Probe, ABoxIsTakenWhereTheMouseIsInItAndComesAlongInThePlaneThatFacesTheCamera) {
  const Broadphase world = two_bodies();
  Probe probe(kRoom);
  probe.hold(Aabb{{8, 8, 8}, {12, 12, 12}});
  probe.grab(look_at(10, 10), world);
  EXPECT_LT((centre(probe) - Vector3f(10, 10, 10)).norm(), 1e-3F) << "it does not jump";
  // The plane through its front, z = 12, 88 from the eye.
  probe.drag(look_at(10 + 100.0F / 88, 10 - 200.0F / 88));
  EXPECT_LT((centre(probe) - Vector3f(11, 8, 10)).norm(), 1e-3F);
  EXPECT_LT((to_eigen(probe.box()).sizes() - Vector3f(4, 4, 4)).norm(), 1e-3F);
}

TEST(Probe, ABoxJumpsToTheBodyThatIsSeenWhereTheMouseIs) {
  const Broadphase world = two_bodies();
  Probe probe(kRoom);
  probe.hold(Aabb{{0, 0, 0}, {2, 2, 2}});
  probe.grab(look_at(10, 10), world);
  EXPECT_LT((centre(probe) - Vector3f(10, 10, 16)).norm(), 1e-3F);
  EXPECT_THAT(met_by(probe, world), ElementsAre(Touch{3, 0}));
}

TEST(Probe, ABoxJumpsAsFarAwayAsItWasWhereNobodyIsSeen) {
  const Broadphase world = two_bodies();
  Probe probe(kRoom);
  probe.hold(Aabb{{0, 0, 0}, {2, 2, 2}});
  probe.grab(look_at(20, 20), world);
  EXPECT_NEAR(centre(probe).z(), 1, 1e-3F);
  EXPECT_NEAR(centre(probe).x(), 10 + 9.9F, 1e-2F);
}

TEST(Probe, ABoxStaysNotFarFromTheWorldAndGrowsWithinLimits) {
  Probe probe(kRoom);
  probe.choose(Tool::box);
  probe.drag(look_at(1e6F, 0));
  EXPECT_LT(std::abs(centre(probe).x()), 60);
  for (int time = 0; time < 100; ++time) probe.resize(1.2F);
  EXPECT_NEAR(to_eigen(probe.box()).sizes().x(), 40, 0.1F);
  for (int time = 0; time < 100; ++time) probe.resize(1 / 1.2F);
  EXPECT_NEAR(to_eigen(probe.box()).sizes().x(), 0.2F, 0.01F);
}

TEST(LineSpan, IsThePartOfARayInABox) {
  const Eigen::AlignedBox3f box(Vector3f(1, 1, 1), Vector3f(3, 3, 3));
  const auto through = span_in(box, Vector3f(0, 2, 2), Vector3f(2, 0, 0));
  ASSERT_TRUE(through);
  EXPECT_EQ(through->first, 0.5F);
  EXPECT_EQ(through->last, 1.5F);
  const auto back = span_in(box, Vector3f(4, 4, 4), Vector3f(-1, -1, -1));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->first, 1);
  EXPECT_EQ(back->last, 3);
  EXPECT_EQ(span_in(box, Vector3f(2, 2, 2), Vector3f(0, 1, 0))->first, 0) << "from inside";
  EXPECT_FALSE(span_in(box, Vector3f(0, 4, 2), Vector3f(1, 0, 0)));
  EXPECT_FALSE(span_in(box, Vector3f(4, 2, 2), Vector3f(1, 0, 0))) << "it is behind";
  EXPECT_FALSE(span_in(box, Vector3f(0, 0, 2), Vector3f(1, 5, 0)));
}

/// A simulation of a few bodies in a row, of which none overlap.
std::unique_ptr<Simulation> row_of_bodies() {
  Recording recording{"row", "", {{0, 0, 0}, {10, 10, 10}}, 4, {}};
  for (int i = 0; i < 4; ++i) {
    const auto x = static_cast<float>(2 * i);
    recording.boxes.push_back({{x, 4, 4}, {x + 1, 5, 5}});
  }
  return std::move(*Simulation::make(
      {.recording = FrameFile(recording), .scene = {}, .engine = "stream", .settings = {}}));
}

std::size_t with_color(std::span<const DrawnBox> boxes, const Color& color) {
  return static_cast<std::size_t>(
      std::count_if(boxes.begin(), boxes.end(), [&](const DrawnBox& box) { return box.color == color; }));
}

TEST(DrawnBoxes, WithoutAToolNothingGlows) {
  const auto simulation = row_of_bodies();
  const DrawnBoxes drawn = drawn_boxes(*simulation, Probe(simulation->bounds()), {});
  EXPECT_EQ(drawn.all.size(), 4U + 12U);
  EXPECT_THAT(drawn.glowing(), IsEmpty());
}

TEST(DrawnBoxes, GlowWhereABoxMeetsThemWithItsTwelveEdges) {
  const auto simulation = row_of_bodies();
  Probe probe(simulation->bounds());
  probe.hold(Aabb{{1, 4, 4}, {4, 5, 5}});
  const DrawnBoxes drawn = drawn_boxes(*simulation, probe, met_by(probe, simulation->engine()));
  EXPECT_EQ(drawn.all.size(), 4U + 12U + 12U);
  ASSERT_EQ(drawn.glowing().size(), 3U + 12U);
  EXPECT_EQ(with_color(drawn.glowing(), drawn.glowing()[0].color), 3U);
  EXPECT_EQ(with_color(drawn.glowing(), drawn.glowing()[14].color), 12U);
}

TEST(DrawnBoxes, TheFirstThatARayTouchesHasAColorOfItsOwn) {
  const auto simulation = row_of_bodies();
  Probe probe(simulation->bounds());
  probe.hold(Ray{{3.5F, 4.5F, 4.5F}, {1, 0, 0}});
  const DrawnBoxes drawn = drawn_boxes(*simulation, probe, met_by(probe, simulation->engine()));
  ASSERT_EQ(drawn.glowing().size(), 2U + 1U);
  EXPECT_EQ(drawn.glowing()[0].centre[0], 4.5F);
  EXPECT_NE(drawn.glowing()[0].color, drawn.glowing()[1].color);
  const DrawnBox& beam = drawn.glowing()[2];
  EXPECT_EQ(beam.centre[1], 4.5F);
  EXPECT_NEAR(beam.centre[0] + beam.half_extents[0], 11.5F, 1e-3F) << "a little out of the world";
  probe.hold(Ray{{3.5F, 40, 4.5F}, {1, 0, 0}});
  EXPECT_THAT(drawn_boxes(*simulation, probe, {}).glowing(), IsEmpty()) << "it is far from the world";
}

}  // namespace
}  // namespace cellsweep::view
