/// @file
/// Calls that are refused: for which reason, and that nothing has changed.
#include <gmock/gmock.h>

#include <limits>

#include "base/threads/numbers_of_workers.h"
#include "base/threads/thread_pool.h"
#include "broadphase/bodies/shown.h"

namespace cellsweep {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const Capacity kFewBodies = {15, "few", "of the test"};

/// Bodies 0 ... 9 but for 3 and 4; an update has seen all but 8 and 9, of which 9 is in a slot that was free.
class RefusedCall : public testing::TestWithParam<unsigned> {
 protected:
  void SetUp() override {
    ASSERT_TRUE(insert(crew_, bodies_, {0, 1, 2, 3, 4, 5, 6, 7}, boxes_from(0, 8)).ok());
    update(bodies_);
    ASSERT_TRUE(bodies_.remove(Ids{3}).ok());
    update(bodies_);
    ASSERT_TRUE(insert(crew_, bodies_, {9, 8}, boxes_from(100, 2)).ok());
    ASSERT_TRUE(move({5, 8}, boxes_from(200, 2)).ok());
    ASSERT_TRUE(bodies_.remove(Ids{4}).ok());
    before_ = shown_by(bodies_);
    bytes_ = bodies_.bytes();
  }

  Status move(const Ids& ids, const std::vector<Aabb>& boxes) { return bodies_.move(crew_, ids, boxes); }

  /// Expects that a call was refused for the fault of these bodies, and that nothing has changed.
  void expect_refused(const Status& status, StatusCode code, const Ids& bodies) {
    EXPECT_EQ(status.code, code) << status.message;
    EXPECT_EQ(status.bodies, bodies) << status.message;
    EXPECT_EQ(shown_by(bodies_), before_) << status.message;
  }

  Crew crew_{std::make_shared<ThreadPool>(GetParam()), GetParam(), Crew::Choice::given};
  Bodies bodies_;
  Shown before_;
  std::size_t bytes_ = 0;
};

TEST_P(RefusedCall, SpansOfDifferentLength) {
  Ids ids(2, 77);
  std::vector<Aabb> boxes = boxes_from(0, 3);
  expect_refused(insert(crew_, bodies_, {20, 21}, boxes), StatusCode::bad_input, {});
  expect_refused(bodies_.add(crew_, boxes, ids, "test", kAnyNumber), StatusCode::bad_input, {});
  expect_refused(move({0, 1}, boxes), StatusCode::bad_input, {});
  expect_refused(bodies_.boxes(ids, boxes), StatusCode::bad_input, {});
  EXPECT_THAT(ids, ElementsAre(77U, 77U));
}

TEST_P(RefusedCall, AnInvalidBoxWhereverItStands) {
  const Ids held = {0, 1, 2, 5, 6, 7, 8, 9};
  for (std::size_t bad = 0; bad < 8; ++bad) {
    for (const float value :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1e9F}) {
      std::vector<Aabb> boxes = boxes_from(300, 8);
      boxes[bad].max[bad % 3] = value;
      const Ids fresh = ids_from(20, 8);
      expect_refused(insert(crew_, bodies_, fresh, boxes), StatusCode::invalid_box, {fresh[bad]});
      expect_refused(move(held, boxes), StatusCode::invalid_box, {held[bad]});
      Ids ids(8, 77);
      expect_refused(bodies_.add(crew_, boxes, ids, "test", kAnyNumber), StatusCode::invalid_box,
                     {static_cast<BodyId>(bad)});
      EXPECT_EQ(ids, Ids(8, 77));
    }
  }
}

TEST_P(RefusedCall, TheFirstBodiesWithAnInvalidBoxWhereverItStands) {
  for (std::size_t bad = 0; bad < 300; bad += 7) {
    std::vector<Aabb> boxes = boxes_from(300, 300);
    const Ids ids = ids_from(0, 300);
    boxes[bad].min[bad % 3] = 1e9F;
    Bodies fresh;
    EXPECT_EQ(insert(crew_, fresh, ids, boxes).bodies, Ids{static_cast<BodyId>(bad)});
    EXPECT_EQ(fresh.size(), 0U);
    boxes[bad].min[bad % 3] = -1e-44F;
    ASSERT_TRUE(insert(crew_, fresh, ids, boxes).ok());
    EXPECT_EQ(fresh.all_boxes()[bad].min[bad % 3], 0.0F);
  }
}

TEST_P(RefusedCall, AnInsertOfABodyThatIsHeldWhereverItStands) {
  for (const BodyId held : {0U, 5U, 8U, 9U}) {
    for (std::size_t place = 0; place < 5; ++place) {
      Ids ids = {20, 0xffffffff, 4, 1'000'000};
      ids.insert(ids.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(place, 4)), held);
      expect_refused(insert(crew_, bodies_, ids, boxes_from(300, 5)), StatusCode::duplicate_body, {held});
    }
  }
  ASSERT_TRUE(insert(crew_, bodies_, {3, 4}, boxes_from(300, 2)).ok()) << "these are not held";
}

TEST_P(RefusedCall, AnInsertOrARemovalOfABodyThatIsListedTwice) {
  expect_refused(insert(crew_, bodies_, {20, 21, 20}, boxes_from(300, 3)), StatusCode::duplicate_body, {20});
  expect_refused(insert(crew_, bodies_, {21, 0, 0xffffffff, 21, 0xffffffff}, boxes_from(300, 5)),
                 StatusCode::duplicate_body, {21, 0xffffffff});
  expect_refused(bodies_.remove(Ids{1, 0, 1}), StatusCode::duplicate_body, {1});
  expect_refused(bodies_.remove(Ids{8, 8}), StatusCode::duplicate_body, {8});
}

TEST_P(RefusedCall, AMoveOrARemovalOfABodyThatIsNotThereWhereverItStands) {
  for (const BodyId unknown : {3U, 4U, 10U, 0xffffffffU}) {
    for (std::size_t place = 0; place <= 7; ++place) {
      Ids ids = {0, 1, 2, 5, 6, 8, 9};
      ids.insert(ids.begin() + static_cast<std::ptrdiff_t>(place), unknown);
      expect_refused(move(ids, boxes_from(300, 8)), StatusCode::unknown_body, {unknown});
      expect_refused(bodies_.remove(ids), StatusCode::unknown_body, {unknown});
    }
  }
}

TEST_P(RefusedCall, MoreBodiesThanThereMayBe) {
  const Status status = insert(crew_, bodies_, ids_from(20, 8), boxes_from(300, 8), kFewBodies);
  expect_refused(status, StatusCode::capacity, {});
  EXPECT_EQ(status.number, 16U);
  EXPECT_EQ(status.limit, 15U);
  EXPECT_EQ(status.setting, "few");
  EXPECT_THAT(status.message, HasSubstr("Engine test takes 15 bodies"));
  Ids ids(8, 77);
  expect_refused(bodies_.add(crew_, boxes_from(300, 8), ids, "test", kFewBodies), StatusCode::capacity, {});
  EXPECT_EQ(ids, Ids(8, 77));
  ASSERT_TRUE(insert(crew_, bodies_, ids_from(20, 7), boxes_from(300, 7), kFewBodies).ok());
}

TEST_P(RefusedCall, MoreBodiesThanThereMayBeAmongWhichOneIsWrongForThat) {
  Ids ids = ids_from(20, 8);
  ids[7] = 20;
  expect_refused(insert(crew_, bodies_, ids, boxes_from(300, 8), kFewBodies), StatusCode::duplicate_body,
                 {20});
  ids[7] = 5;
  expect_refused(insert(crew_, bodies_, ids, boxes_from(300, 8), kFewBodies), StatusCode::duplicate_body,
                 {5});
  std::vector<Aabb> boxes = boxes_from(300, 8);
  boxes[2] = kNobody;
  expect_refused(insert(crew_, bodies_, ids, boxes, kFewBodies), StatusCode::invalid_box, {22});
}

TEST_P(RefusedCall, MoreBodiesThanThereMayBeTakeNoMemory) {
  Ids ids(100'000);
  const std::vector<Aabb> boxes = boxes_from(300, ids.size());
  expect_refused(bodies_.add(crew_, boxes, ids, "test", kFewBodies), StatusCode::capacity, {});
  expect_refused(insert(crew_, bodies_, ids_from(20, ids.size()), boxes, kFewBodies), StatusCode::capacity,
                 {});
  EXPECT_EQ(bodies_.bytes(), bytes_);
}

TEST_P(RefusedCall, OfNobodyIsNone) {
  Ids none;
  EXPECT_TRUE(insert(crew_, bodies_, {}, {}).ok());
  EXPECT_TRUE(bodies_.add(crew_, {}, none, "test", kAnyNumber).ok());
  EXPECT_TRUE(move({}, {}).ok());
  EXPECT_TRUE(bodies_.remove({}).ok());
  EXPECT_TRUE(bodies_.boxes({}, {}).ok());
  EXPECT_EQ(shown_by(bodies_), before_);
}

INSTANTIATE_TEST_SUITE_P(Workers, RefusedCall, numbers_of_workers());

}  // namespace
}  // namespace cellsweep
