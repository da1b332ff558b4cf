/// @file
/// Engines that make boxes from poses (F3): the boxes enclose, the pairs are those of the boxes handed out,
/// and neither depends on how many SPUs made them or on when transfers land. All others refuse poses.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "cellsweep/cell.h"
#include "contract/contract_engines.h"
#include "contract/effort.h"
#include "contract/random.h"
#include "engines/oracle/brute_force.h"
#include "world/scene_probe.h"

namespace cellsweep::contract {
namespace {

Broadphase make_boxes_maker(CellResidentOptions options = {}) {
  options.spu_boxes = true;
  auto engine = make_broadphase(options);
  EXPECT_TRUE(engine.ok()) << engine.status().message;
  return std::move(*engine);
}

BodyPose random_pose(Random& random) {
  BodyPose pose;
  for (int k = 0; k < 3; ++k) {
    pose.centre[k] = random.between(-6, 6);
    pose.half_extents[k] = random.one_in(8) ? 0 : random.between(0.01F, random.one_in(10) ? 3.0F : 0.7F);
  }
  if (random.one_in(4)) return pose;
  for (float& x : pose.orientation) x = random.between(-1, 1);
  pose.orientation[3] += 1.5F;
  return pose;
}

/// The interval that a turned box covers on an axis: its eight corners, each turned in doubles.
void widen_to_corners(const BodyPose& pose, int axis, double& low, double& high) {
  const auto [x, y, z, w] = pose.orientation;
  const double q[4] = {x, y, z, w};
  const double n = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  for (int corner = 0; corner < 8; ++corner) {
    double e[3];
    for (int k = 0; k < 3; ++k) e[k] = (corner >> k & 1) != 0 ? pose.half_extents[k] : -pose.half_extents[k];
    // v + 2 (w (u × v) + u × (u × v)) / |q|²
    const double c[3] = {q[1] * e[2] - q[2] * e[1], q[2] * e[0] - q[0] * e[2], q[0] * e[1] - q[1] * e[0]};
    const double d[3] = {q[1] * c[2] - q[2] * c[1], q[2] * c[0] - q[0] * c[2], q[0] * c[1] - q[1] * c[0]};
    const double turned = pose.centre[axis] + e[axis] + 2 * (q[3] * c[axis] + d[axis]) / n;
    low = std::min(low, turned);
    high = std::max(high, turned);
  }
}

testing::AssertionResult encloses(const Aabb& box, const BodyPose& pose) {
  for (int axis = 0; axis < 3; ++axis) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    widen_to_corners(pose, axis, low, high);
    const double rounding = 1e-14 * (1 + std::fabs(low) + std::fabs(high));
    const double slack = 3e-6 * (1 + std::fabs(low) + std::fabs(high));
    if (box.min[axis] > low + rounding || box.max[axis] < high - rounding)
      return testing::AssertionFailure() << "axis " << axis << ": " << box.min[axis] << " to "
                                         << box.max[axis] << " does not enclose " << low << " to " << high;
    if (box.min[axis] < low - slack || box.max[axis] > high + slack)
      return testing::AssertionFailure() << "axis " << axis << " is too wide";
  }
  return testing::AssertionSuccess();
}

/// What an engine should know of a body: its pose, or the box its caller gave.
struct Known {
  std::optional<BodyPose> pose;
  Aabb box;
};

/// Everything an engine said in the course of a random life.
struct Said {
  std::vector<Aabb> boxes;
  std::vector<Pair> began;
  std::vector<Pair> ended;

  friend bool operator==(const Said&, const Said&) = default;
};

/// Random calls with poses and boxes, the engine's answers compared after each update.
class PoseCaller {
 public:
  PoseCaller(const CellResidentOptions& options, std::uint64_t seed)
      : random_(seed), engine_(make_boxes_maker(options)) {}

  void step(std::size_t most) {
    for (BodyId id = 0; id < most; ++id) {
      if (bodies_.count(id) == 0) {
        if (random_.one_in(3)) insert(id);
      } else if (random_.one_in(12)) {
        ASSERT_TRUE(engine_.remove(id).ok());
        bodies_.erase(id);
        // The slot is taken at once by a body of which the engine knows no pose.
        if (random_.one_in(2)) insert(id + 1000);
      } else if (random_.one_in(3)) {
        move(id);
      }
    }
    update();
  }

  const Said& said() const { return said_; }

 private:
  Aabb random_box() {
    Aabb box;
    for (int k = 0; k < 3; ++k) {
      box.min[k] = random_.between(-6, 6);
      box.max[k] = box.min[k] + random_.between(0, 2);
    }
    return box;
  }

  void insert(BodyId id) {
    if (bodies_.count(id) != 0) return;
    Known body{random_pose(random_), random_box()};
    if (random_.one_in(5)) body.pose.reset();
    const Status status = body.pose ? insert_poses(engine_, std::span(&id, 1), std::span(&*body.pose, 1))
                                    : engine_.insert(id, body.box);
    ASSERT_TRUE(status.ok()) << status.message;
    bodies_[id] = body;
  }

  void move(BodyId id) {
    Known& body = bodies_[id];
    if (random_.one_in(5)) {
      body = {std::nullopt, random_box()};
      ASSERT_TRUE(engine_.move(id, body.box).ok());
      if (random_.one_in(2)) return;
    }
    body.pose = random_.one_in(4) && body.pose ? *body.pose : random_pose(random_);
    ASSERT_TRUE(move_poses(engine_, std::span(&id, 1), std::span(&*body.pose, 1)).ok());
  }

  void update() {
    const auto changes = engine_.update();
    ASSERT_TRUE(changes.ok()) << changes.status().message;
    std::vector<BodyId> ids;
    for (const auto& [id, body] : bodies_) ids.push_back(id);
    std::vector<Aabb> boxes(ids.size());
    ASSERT_TRUE(engine_.boxes(ids, boxes).ok());
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const Known& body = bodies_[ids[i]];
      const bool as_given = !body.pose && boxes[i] == body.box;
      ASSERT_TRUE(body.pose ? encloses(boxes[i], *body.pose) : testing::AssertionResult(as_given))
          << "body " << ids[i];
    }
    ASSERT_TRUE(std::ranges::equal(engine_.pairs(), brute_force_pairs(ids, boxes)));
    said_.boxes.insert(said_.boxes.end(), boxes.begin(), boxes.end());
    said_.began.insert(said_.began.end(), changes->began.begin(), changes->began.end());
    said_.ended.insert(said_.ended.end(), changes->ended.begin(), changes->ended.end());
  }

  Random random_;
  Broadphase engine_;
  std::map<BodyId, Known> bodies_;
  Said said_;
};

Said life(const CellResidentOptions& options, std::uint64_t seed, std::size_t most = 90) {
  PoseCaller caller(options, seed);
  for (int step = 0; step < 10 && !testing::Test::HasFatalFailure(); ++step) caller.step(most);
  return caller.said();
}

TEST(PoseContract, BoxesEncloseAndPairsAreThoseOfTheBoxesHandedOut) {
  for (std::uint64_t seed = 1; seed <= effort(20, 3) && !testing::Test::HasFatalFailure(); ++seed)
    life({}, seed);
}

TEST(PoseContract, NeitherSpusNorTransferModesChangeABitOfABoxOrTheOrderOfAList) {
  constexpr std::size_t kMost = effort(300, 60);
  const Said reference = life({}, 77, kMost);
  ASSERT_FALSE(reference.began.empty());
  for (const unsigned spus : {3U, 4U, 5U, 7U, 16U}) {
    EXPECT_TRUE(reference == life({.spus = spus}, 77, kMost)) << spus << " SPUs";
    EXPECT_TRUE(reference ==
                life({.spes = {.dma = DmaMode::late, .dma_seed = spus}, .spus = spus}, 77, kMost))
        << spus << " SPUs, late DMA";
  }
  // An emulated processor runs programs of a real SPU, which has a limit.
  const std::uint64_t local_store = kEmulated ? SpeOptions{}.local_store : 0;
  EXPECT_TRUE(reference ==
              life({.spes = {.local_store = local_store, .dma = DmaMode::unchecked}}, 77, kMost));
}

TEST(PoseContract, AFullEngineMakesAllBoxesInOneUpdate) {
  for (const DmaMode mode : {DmaMode::eager, DmaMode::late}) {
    Broadphase engine = make_boxes_maker({.spes = {.local_store = 128 << 10, .dma = mode}});
    Random random(3);
    const auto count = static_cast<std::size_t>(engine.capacity().bodies);
    std::vector<BodyId> ids;
    std::vector<BodyPose> poses;
    for (std::size_t i = 0; i < count; ++i) {
      ids.push_back(static_cast<BodyId>(i));
      poses.push_back(random_pose(random));
      poses.back().centre[0] += static_cast<float>(i);
    }
    ASSERT_TRUE(insert_poses(engine, ids, poses).ok());
    ASSERT_TRUE(engine.update().ok());
    std::vector<Aabb> boxes(count);
    ASSERT_TRUE(engine.boxes(ids, boxes).ok());
    for (std::size_t i = 0; i < count; ++i) ASSERT_TRUE(encloses(boxes[i], poses[i])) << "body " << i;
  }
}

TEST(PoseContract, TheBitsOfBoxesAreTheSameOnEveryMachine) {
  Broadphase engine = make_boxes_maker();
  Random random(11);
  std::vector<BodyId> ids;
  std::vector<BodyPose> poses;
  while (ids.size() < 200) {
    ids.push_back(static_cast<BodyId>(ids.size()));
    poses.push_back(random_pose(random));
  }
  ASSERT_TRUE(insert_poses(engine, ids, poses).ok());
  ASSERT_TRUE(engine.update().ok());
  std::vector<Aabb> boxes(ids.size());
  ASSERT_TRUE(engine.boxes(ids, boxes).ok());
  EXPECT_EQ(hash_text(test::bits_hash(boxes)), "5414dd6765ab8e10");
}

TEST(PoseContract, ABodyThatIsNotTurnedHasCentrePlusAndMinusItsHalfExtents) {
  Broadphase engine = make_boxes_maker();
  const BodyId id = 4;
  const BodyPose pose{{1.5F, -2, 0.25F}, {0.5F, 2, 1e-39F}, {0, 0, 0, 1}};
  ASSERT_TRUE(insert_poses(engine, std::span(&id, 1), std::span(&pose, 1)).ok());
  ASSERT_TRUE(engine.update().ok());
  Aabb box;
  ASSERT_TRUE(engine.boxes(std::span(&id, 1), std::span(&box, 1)).ok());
  EXPECT_EQ(box, (Aabb{{1, -4, 0.25F}, {2, 0, 0.25F}}));
  EXPECT_FALSE(std::signbit(box.max[1]));
}

TEST(PoseContract, PosesThatAreNoneAreRefusedAndChangeNothing) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const BodyPose good;
  std::vector<BodyPose> bad(9, good);
  bad[0].centre[1] = nan;
  bad[1].centre[2] = infinity;
  bad[2].half_extents[0] = -1;
  bad[3].half_extents[1] = nan;
  bad[4].orientation = {0, 0, 0, 0};
  bad[5].orientation[0] = nan;
  bad[6].orientation[3] = 1025;
  bad[7].orientation[3] = 1e-4F;
  bad[8].half_extents[2] = std::nextafter(kLargestPoseReach, infinity);
  Broadphase engine = make_boxes_maker();
  const std::vector<BodyId> ids = {1, 2};
  for (std::size_t i = 0; i < bad.size(); ++i) {
    const Status status = insert_poses(engine, ids, std::vector<BodyPose>{good, bad[i]});
    EXPECT_EQ(status.code, StatusCode::invalid_box) << "pose " << i;
    EXPECT_EQ(status.body, BodyId{2}) << status.message;
  }
  EXPECT_EQ(engine.size(), 0U);
  ASSERT_TRUE(insert_poses(engine, ids, std::vector<BodyPose>(2)).ok());
  EXPECT_EQ(move_poses(engine, ids, std::vector<BodyPose>{good, bad[0]}).code, StatusCode::invalid_box);
  EXPECT_EQ(move_poses(engine, ids, std::vector<BodyPose>(1)).code, StatusCode::bad_input);
  EXPECT_EQ(move_poses(engine, std::vector<BodyId>{3}, std::vector<BodyPose>(1)).code,
            StatusCode::unknown_body);
  EXPECT_EQ(insert_poses(engine, ids, std::vector<BodyPose>(2)).code, StatusCode::duplicate_body);
  std::vector<Aabb> boxes(2);
  EXPECT_EQ(engine.boxes(ids, boxes).code, StatusCode::unknown_body) << "no update has seen them";
  ASSERT_TRUE(engine.update().ok());
  EXPECT_TRUE(engine.boxes(ids, boxes).ok());
  EXPECT_EQ(engine.boxes(ids, std::span(boxes).first(1)).code, StatusCode::bad_input);
}

TEST(PoseContract, OfSeveralPosesAndBoxesForABodyTheLastCounts) {
  Broadphase engine = make_boxes_maker();
  const auto pose_at = [](float x) { return BodyPose{{x, 0, 0}, {1, 1, 1}, {0, 0, 0, 1}}; };
  const std::vector<BodyId> ids = {1, 2};
  const std::vector<BodyId> twice = {1, 1};
  ASSERT_TRUE(insert_poses(engine, ids, std::vector<BodyPose>{pose_at(3), pose_at(9)}).ok());
  ASSERT_TRUE(move_poses(engine, twice, std::vector<BodyPose>{pose_at(5), pose_at(7)}).ok());
  ASSERT_TRUE(engine.move(2, Aabb{{20, 0, 0}, {21, 1, 1}}).ok());
  ASSERT_TRUE(engine.update().ok());
  std::vector<Aabb> boxes(2);
  ASSERT_TRUE(engine.boxes(ids, boxes).ok());
  EXPECT_EQ(boxes[0], (Aabb{{6, -1, -1}, {8, 1, 1}}));
  EXPECT_EQ(boxes[1], (Aabb{{20, 0, 0}, {21, 1, 1}}));
}

TEST(PoseContract, TheLargestPosesThatAreTakenGiveFiniteBoxes) {
  Broadphase engine = make_boxes_maker();
  BodyPose pose;
  pose.half_extents = {kLargestPoseReach / 4, kLargestPoseReach / 4, kLargestPoseReach / 4};
  pose.centre = {kLargestPoseReach / 4, -kLargestPoseReach / 4, 0};
  for (float& x : pose.orientation) x = 500;
  const BodyId id = 0;
  ASSERT_TRUE(insert_poses(engine, std::span(&id, 1), std::span(&pose, 1)).ok());
  ASSERT_TRUE(engine.update().ok());
  Aabb box;
  ASSERT_TRUE(engine.boxes(std::span(&id, 1), std::span(&box, 1)).ok());
  for (int k = 0; k < 3; ++k) EXPECT_TRUE(std::isfinite(box.min[k]) && std::isfinite(box.max[k]));
}

TEST(PoseRefusals, EnginesWithoutTheOptionRefusePoses) {
  for (const ContractEngine& given : contract_engines()) {
    if (given.takes_poses) continue;
    Broadphase engine = make(given);
    const BodyId id = 1;
    const BodyPose pose;
    Status status = insert_poses(engine, std::span(&id, 1), std::span(&pose, 1));
    EXPECT_EQ(status.code, StatusCode::bad_option) << given.label;
    EXPECT_EQ(status.setting, "spu_boxes");
    ASSERT_TRUE(engine.insert(id, Aabb{}).ok());
    status = move_poses(engine, std::span(&id, 1), std::span(&pose, 1));
    EXPECT_EQ(status.code, StatusCode::bad_option) << given.label;
    EXPECT_EQ(status.setting, "spu_boxes");
    EXPECT_EQ(engine.size(), 1U);
  }
}

}  // namespace
}  // namespace cellsweep::contract
