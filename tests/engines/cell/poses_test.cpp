/// @file
/// Poses (F3): who takes them, which are refused in which words, and that their boxes are there at once.
#include <gmock/gmock.h>

#include <cmath>

#include "engines/cell/cell_world.h"
#include "engines/cell/ppu/pose_blocks.h"
#include "engines/oracle/brute_force.h"

namespace cellsweep::cell {
namespace {

using contract::Random;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

Broadphase make_boxes_maker(CellResidentOptions options = {}) {
  options.spu_boxes = true;
  return make(options);
}

BodyPose at(float x) {
  BodyPose pose;
  pose.centre = {x, 10 * x, 100 * x};
  pose.half_extents = {1, 2, 3};
  return pose;
}

std::vector<BodyPose> random_poses(Random& random, std::size_t count) {
  std::vector<BodyPose> poses(count);
  for (BodyPose& pose : poses) {
    for (float& x : pose.centre) x = random.between(-6, 6);
    for (float& x : pose.half_extents) x = random.between(0, 0.7F);
    for (float& x : pose.orientation) x = random.between(-1, 1);
    pose.orientation[3] += 1.5F;
  }
  return poses;
}

TEST(PoseBlocks, HoldFourPosesALaneEachAndGoodOnesInTheLanesLeftOver) {
  std::vector<PoseBlock> blocks(2);
  pack(std::vector<BodyPose>{at(1), at(2), at(3), at(4), at(5)}, blocks);
  EXPECT_EQ(blocks[0].centre[0][3], 4);
  EXPECT_EQ(blocks[0].centre[2][1], 200);
  EXPECT_EQ(blocks[0].half_extents[1][0], 2);
  EXPECT_EQ(blocks[1].centre[1][0], 50);
  EXPECT_EQ(blocks[1].orientation[3][3], 1) << "a lane without a body holds a good quaternion";
}

TEST(Poses, AreRefusedByEnginesThatMakeNoBoxesOfThem) {
  std::vector<Broadphase> engines;
  for (const NamedEngine& engine : kEngines) engines.push_back(std::move(*engine.make({})));
  engines.push_back(std::move(*make_broadphase(OracleOptions{})));
  for (Broadphase& engine : engines) {
    const BodyId id = 1;
    const BodyPose pose;
    const Status status = insert_poses(engine, {&id, 1}, {&pose, 1});
    EXPECT_EQ(status.code, StatusCode::bad_option);
    EXPECT_EQ(status.setting, "spu_boxes");
    EXPECT_THAT(status.message, HasSubstr(std::string(engine.name()) + " makes no boxes from poses"));
    ASSERT_TRUE(engine.insert(id, cube(0)).ok());
    EXPECT_EQ(move_poses(engine, {&id, 1}, {&pose, 1}).code, StatusCode::bad_option);
  }
}

TEST(Poses, BecomeTheBoxesThatTheEngineHoldsAfterTheNextUpdate) {
  Broadphase engine = make_boxes_maker();
  const std::vector<BodyId> ids = {4, 9};
  ASSERT_TRUE(insert_poses(engine, ids, std::vector<BodyPose>{at(0), at(10)}).ok());
  EXPECT_EQ(engine.size(), 2U);
  ASSERT_TRUE(engine.update().ok());
  std::vector<Aabb> boxes(2);
  ASSERT_TRUE(engine.boxes(ids, boxes).ok());
  EXPECT_THAT(boxes, ElementsAre(Aabb{{-1, -2, -3}, {1, 2, 3}}, Aabb{{9, 98, 997}, {11, 102, 1003}}));
  ASSERT_TRUE(move_poses(engine, std::vector<BodyId>{9}, std::vector<BodyPose>{at(1)}).ok());
  ASSERT_TRUE(engine.boxes(ids, boxes).ok());
  EXPECT_EQ(boxes[1].min[0], 9) << "as of the last update";
  EXPECT_THAT(engine.update()->began, testing::SizeIs(0)) << "they are apart on z";
  ASSERT_TRUE(move_poses(engine, std::vector<BodyId>{9}, std::vector<BodyPose>{at(0)}).ok());
  EXPECT_THAT(engine.update()->began, ElementsAre(Pair{4, 9}));
}

TEST(Poses, AndBoxesMayBeGivenToABodyInTurn) {
  Broadphase engine = make_boxes_maker();
  const std::vector<BodyId> ids = {1, 2};
  ASSERT_TRUE(engine.insert(ids, std::vector<Aabb>{cube(0), cube(50)}).ok());
  ASSERT_TRUE(move_poses(engine, ids, std::vector<BodyPose>{at(0), at(0)}).ok());
  ASSERT_TRUE(engine.move(2, cube(50)).ok());
  ASSERT_TRUE(engine.update().ok());
  std::vector<Aabb> boxes(2);
  ASSERT_TRUE(engine.boxes(ids, boxes).ok());
  EXPECT_THAT(boxes, ElementsAre(Aabb{{-1, -2, -3}, {1, 2, 3}}, cube(50)));
}

TEST(Poses, ThatAreNoneAreRefusedTogetherAndChangeNothing) {
  Broadphase engine = make_boxes_maker();
  std::vector<BodyPose> poses(5);
  poses[1].centre[1] = std::nanf("");
  poses[2].half_extents[0] = -1;
  poses[4].orientation = {0, 0, 0, 0};
  const Status status = insert_poses(engine, std::vector<BodyId>{10, 11, 12, 13, 14}, poses);
  EXPECT_EQ(status.code, StatusCode::invalid_box);
  EXPECT_EQ(status.body, BodyId{11});
  EXPECT_THAT(status.bodies, ElementsAre(11, 12, 14));
  EXPECT_EQ(status.number, 3U);
  EXPECT_THAT(status.message, HasSubstr("The pose of body 11 is refused: centre and half extents"));
  EXPECT_THAT(status.message, HasSubstr("; body 12: a half extent is not 0 or more"));
  EXPECT_THAT(status.message, HasSubstr("; body 14: its orientation's length is 0"));
  EXPECT_EQ(engine.size(), 0U);
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(counter(engine, "poses sent"), 0U);
}

TEST(Poses, ThatAreNoneAreNamedAsFarAsAStatusGoes) {
  Broadphase engine = make_boxes_maker();
  BodyPose bad;
  bad.orientation[3] = 1025;
  const Status status = insert_poses(engine, ids_up_to(20), std::vector<BodyPose>(20, bad));
  EXPECT_EQ(status.bodies, ids_up_to(Status::kMostBodies));
  EXPECT_EQ(status.number, 20U);
  EXPECT_THAT(status.message, HasSubstr("; body 15: "));
  EXPECT_THAT(status.message, Not(HasSubstr("body 16")));
  EXPECT_THAT(status.message, HasSubstr("; and 4 more."));
}

TEST(Poses, NeedAnIdEachThatIsRightForTheCall) {
  Broadphase engine = make_boxes_maker();
  const std::vector<BodyId> ids = {1, 2};
  const std::vector<BodyPose> poses(2);
  const Status uneven = insert_poses(engine, ids, std::vector<BodyPose>(3));
  EXPECT_EQ(uneven.code, StatusCode::bad_input);
  EXPECT_THAT(uneven.message, HasSubstr("2 ids but 3 poses"));
  EXPECT_EQ(move_poses(engine, ids, poses).code, StatusCode::unknown_body);
  EXPECT_EQ(insert_poses(engine, std::vector<BodyId>{1, 1}, poses).code, StatusCode::duplicate_body);
  ASSERT_TRUE(insert_poses(engine, ids, poses).ok());
  EXPECT_EQ(insert_poses(engine, ids, poses).code, StatusCode::duplicate_body);
  EXPECT_TRUE(move_poses(engine, ids, poses).ok());
  EXPECT_TRUE(insert_poses(engine, {}, {}).ok());
}

TEST(Poses, ThatFitIntoNoOrderTogetherGoInSeveral) {
  Broadphase engine = make_boxes_maker({.spes = {.local_store = 96 << 10, .dma = DmaMode::late}});
  const auto room = static_cast<std::size_t>(engine.capacity().bodies);
  Random random(3);
  const std::vector<BodyId> ids = ids_up_to(room);
  ASSERT_TRUE(insert_poses(engine, ids, random_poses(random, room)).ok());
  // Each body is listed three times; what counts is its last pose.
  std::vector<BodyId> often;
  for (int time = 0; time < 3; ++time) often.insert(often.end(), ids.begin(), ids.end());
  const std::vector<BodyPose> poses = random_poses(random, often.size());
  ASSERT_TRUE(move_poses(engine, often, poses).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(counter(engine, "poses sent"), 4 * room);
  std::vector<Aabb> boxes(room);
  ASSERT_TRUE(engine.boxes(ids, boxes).ok());
  Broadphase other = make_boxes_maker();
  ASSERT_TRUE(insert_poses(other, ids, std::span(poses).last(room)).ok());
  ASSERT_TRUE(other.update().ok());
  std::vector<Aabb> expected(room);
  ASSERT_TRUE(other.boxes(ids, expected).ok());
  EXPECT_EQ(boxes, expected);
  EXPECT_EQ(pairs_of(engine), brute_force_pairs(boxes));
}

TEST(Poses, AsTheyWereMoveNothing) {
  Broadphase engine = make_boxes_maker();
  const std::vector<BodyId> ids = ids_up_to(3);
  ASSERT_TRUE(insert_poses(engine, ids, std::vector<BodyPose>(3)).ok());
  ASSERT_TRUE(engine.update().ok());
  const std::uint64_t sent = counter(engine, "bodies sent");
  ASSERT_TRUE(move_poses(engine, ids, std::vector<BodyPose>(3)).ok());
  ASSERT_TRUE(engine.update().ok());
  EXPECT_EQ(counter(engine, "bodies sent"), sent);
}

}  // namespace
}  // namespace cellsweep::cell
