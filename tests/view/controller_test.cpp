#include "view/controller.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace cellsweep::view {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A controller with its simulation of scene `paper`.
class Keys : public testing::Test {
 protected:
  static std::unique_ptr<Simulation> made(std::size_t bodies) {
    return std::move(*Simulation::make({.recording = std::nullopt,
                                        .scene = {.scene = "paper", .bodies = bodies, .moving = 0.1},
                                        .engine = "stream",
                                        .settings = {}}));
  }

  std::unique_ptr<Simulation> simulation_ = made(64);
  Controller controller_{*simulation_};
};

TEST_F(Keys, AreEachForOneThingAndSaidInTheHelp) {
  std::set<int> keys;
  std::set<Action> actions;
  for (const KeyBinding& binding : key_bindings()) {
    EXPECT_TRUE(keys.insert(binding.key).second) << binding.name;
    EXPECT_TRUE(actions.insert(binding.action).second) << binding.name;
    EXPECT_FALSE(binding.name.empty());
    EXPECT_FALSE(binding.text.empty());
  }
  EXPECT_EQ(actions.size(), static_cast<std::size_t>(Action::quit) + 1);
}

TEST_F(Keys, PauseAndGoOn) {
  controller_.tick();
  EXPECT_EQ(simulation_->frame(), 1U);
  controller_.press(' ');
  controller_.tick();
  EXPECT_EQ(simulation_->frame(), 1U);
  controller_.press(' ');
  controller_.tick();
  EXPECT_EQ(simulation_->frame(), 2U);
}

TEST_F(Keys, GoOneFrameOnAndStop) {
  controller_.press('N');
  controller_.tick();
  EXPECT_EQ(simulation_->frame(), 1U);
  EXPECT_TRUE(controller_.paused());
  controller_.press('N');
  EXPECT_EQ(simulation_->frame(), 2U);
  controller_.press('R');
  EXPECT_EQ(simulation_->frame(), 0U);
}

TEST_F(Keys, GoThroughAllEnginesAndBack) {
  std::set<std::string> seen;
  for (std::size_t press = 0; press < engine_table().size(); ++press) {
    controller_.press('E');
    seen.insert(simulation_->engine_name());
  }
  EXPECT_EQ(seen.size(), engine_table().size());
  EXPECT_EQ(simulation_->engine_name(), "stream");
  controller_.press('E');
  controller_.press('Q');
  EXPECT_EQ(simulation_->engine_name(), "stream");
}

TEST_F(Keys, PassAnEngineThatIsRefusedWithTheNextPress) {
  const auto large = made(5000);
  Controller controller(*large);
  controller.use_engine("control");
  EXPECT_EQ(large->engine_name(), "stream");
  EXPECT_THAT(controller.complaint(), HasSubstr("5000"));
  controller.press('Q');  // control is the first of the table
  EXPECT_EQ(large->engine_name(), engine_table().back().name);
  EXPECT_THAT(controller.complaint(), IsEmpty());
}

TEST_F(Keys, ChangeTheNumberOfBodies) {
  controller_.press('B');
  EXPECT_EQ(simulation_->bodies(), 128U);
  controller_.press('V');
  controller_.press('V');
  EXPECT_EQ(simulation_->bodies(), 32U);
  for (int press = 0; press < 8; ++press) controller_.press('V');
  EXPECT_EQ(simulation_->bodies(), 1U);
}

TEST_F(Keys, ChangeTheMovingShareByTenths) {
  for (int press = 0; press < 3; ++press) controller_.press('M');
  EXPECT_DOUBLE_EQ(simulation_->moving(), 0.4);
  for (int press = 0; press < 6; ++press) controller_.press('L');
  EXPECT_EQ(simulation_->moving(), 0);
  for (int press = 0; press < 12; ++press) controller_.press('M');
  EXPECT_EQ(simulation_->moving(), 1);
  EXPECT_THAT(controller_.complaint(), IsEmpty());
}

TEST_F(Keys, MoveTheCamera) {
  const Eigen::Vector3f first = controller_.camera().eye();
  for (const int key : {int{kLeft}, int{kRight}, int{kUp}, int{kDown}, int{'+'}, int{'-'}}) {
    controller_.press(key);
    EXPECT_GT((controller_.camera().eye() - first).norm(), 0.1F) << key;
    controller_.press('0');
    EXPECT_EQ(controller_.camera().eye(), first);
  }
}

TEST_F(Keys, ShowAndHidePanelAndHelpAndEnd) {
  EXPECT_TRUE(controller_.shows_panel());
  controller_.press('P');
  EXPECT_FALSE(controller_.shows_panel());
  EXPECT_FALSE(controller_.shows_help());
  controller_.press('H');
  EXPECT_TRUE(controller_.shows_help());
  EXPECT_FALSE(controller_.wants_to_quit());
  controller_.press(kEscape);
  EXPECT_TRUE(controller_.wants_to_quit());
}

TEST_F(Keys, ShowFatBoxesAndCellsOfStreamAndHideThem) {
  EXPECT_FALSE(controller_.stream_parts().fat_boxes || controller_.stream_parts().cells);
  controller_.press('F');
  EXPECT_TRUE(controller_.stream_parts().fat_boxes);
  EXPECT_FALSE(controller_.stream_parts().cells);
  controller_.press('C');
  controller_.press('F');
  EXPECT_FALSE(controller_.stream_parts().fat_boxes);
  EXPECT_TRUE(controller_.stream_parts().cells);
  EXPECT_THAT(controller_.complaint(), IsEmpty());
}

TEST_F(Keys, ChooseAToolAndMakeItsBoxLargerAndSmaller) {
  EXPECT_EQ(controller_.probe().tool(), Tool::none);
  controller_.press('T');
  EXPECT_EQ(controller_.probe().tool(), Tool::box);
  const auto edge = [&] { return controller_.probe().box().max[0] - controller_.probe().box().min[0]; };
  const float before = edge();
  controller_.press('G');
  controller_.press('G', true);
  EXPECT_GT(edge(), 1.4F * before);
  for (int press = 0; press < 3; ++press) controller_.press('S');
  EXPECT_LT(edge(), before);
  controller_.press('T');
  EXPECT_EQ(controller_.probe().tool(), Tool::ray);
}

TEST_F(Keys, LeaveTheToolInAWorldOfAnotherSize) {
  const auto other = std::move(*Simulation::make({.recording = std::nullopt,
                                                  .scene = {.scene = "uniform", .bodies = 64},
                                                  .engine = "stream",
                                                  .settings = {}}));
  Controller controller(*other);
  controller.press('T');
  const Aabb before = controller.probe().box();
  for (int press = 0; press < 3; ++press) controller.press('B');
  EXPECT_EQ(controller.probe().tool(), Tool::box);
  EXPECT_GT(controller.probe().box().max[0] - controller.probe().box().min[0], before.max[0] - before.min[0]);
}

TEST_F(Keys, TheMouseDragsARayThroughThePicture) {
  controller_.press('T');
  controller_.press('T');
  controller_.grab({450, 300}, 900, 600);
  const auto middle = controller_.probe().ray().direction;
  EXPECT_EQ(controller_.probe().ray().origin[1], controller_.camera().eye().y());
  controller_.drag({0, 300}, 900, 600);
  EXPECT_NE(controller_.probe().ray().direction, middle);
}

TEST_F(Keys, SayThatAnotherEngineHasNoCellsToShow) {
  controller_.use_engine("control");
  controller_.press('C');
  EXPECT_THAT(controller_.complaint(), HasSubstr("control has no fat boxes and cells"));
  EXPECT_TRUE(controller_.stream_parts().cells) << "they show when stream runs again";
  controller_.press('C');
  EXPECT_THAT(controller_.complaint(), IsEmpty());
}

TEST_F(Keys, ShowAllOfARefusalUntilTheNext) {
  controller_.use_engine("nosuch");
  EXPECT_FALSE(controller_.shows_reason());
  controller_.press('W');
  EXPECT_TRUE(controller_.shows_reason());
  controller_.use_engine("nosuch");
  EXPECT_FALSE(controller_.shows_reason());
}

TEST_F(Keys, ThatAreHeldStepAndTurnAgainButDoNotDoubleTheBodiesAgain) {
  controller_.press('B');
  controller_.press('B', true);
  EXPECT_EQ(simulation_->bodies(), 128U);
  controller_.press('N');
  controller_.press('N', true);
  EXPECT_EQ(simulation_->frame(), 2U);
}

TEST_F(Keys, ThatAreForNothingDoNothing) {
  controller_.press('X');
  EXPECT_THAT(controller_.complaint(), IsEmpty());
  EXPECT_EQ(simulation_->frame(), 0U);
  EXPECT_FALSE(controller_.paused());
}

TEST_F(Keys, SayWhatARecordingDoesNotLetThemChange) {
  const Recording one{"one", "boxes", Aabb{{0, 0, 0}, {2, 2, 2}}, 1, {Aabb{{0, 0, 0}, {1, 1, 1}}}};
  const auto recording = std::move(
      *Simulation::make({.recording = FrameFile(one), .scene = {}, .engine = "stream", .settings = {}}));
  Controller controller(*recording);
  controller.press('B');
  EXPECT_THAT(controller.complaint(), HasSubstr("recording"));
  controller.press('E');
  EXPECT_THAT(controller.complaint(), IsEmpty());
}

}  // namespace
}  // namespace cellsweep::view
