/// @file
/// The sentences that refuse a call, and whom they name.
#include "broadphase/bodies/refusals.h"

#include <gmock/gmock.h>

#include <limits>
#include <numeric>
#include <vector>

namespace cellsweep {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Ids = std::vector<BodyId>;

constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr Aabb kGood = {{0, 0, 0}, {1, 1, 1}};
constexpr Aabb kReversed = {{0, 7.5F, 0}, {1, 3.25F, 1}};

IdTable table_with(const Ids& ids) {
  IdTable table;
  List<Slot> slots;
  EXPECT_TRUE(table.insert(ids, slots));
  return table;
}

Ids ids_upwards(BodyId first, std::size_t count) {
  Ids ids(count);
  std::iota(ids.begin(), ids.end(), first);
  return ids;
}

/// These bodies are at fault, all of which are named.
void expect_bodies(const Status& status, StatusCode code, const Ids& bodies) {
  EXPECT_EQ(status.code, code) << status.message;
  EXPECT_EQ(status.body, bodies.front());
  EXPECT_EQ(status.bodies, bodies);
  EXPECT_EQ(status.number, bodies.size());
  EXPECT_EQ(status.message.back(), '.');
}

TEST(LengthStatus, NamesBothLengths) {
  const Status status = length_status(31, 47);
  EXPECT_EQ(status.code, StatusCode::bad_input);
  EXPECT_EQ(status.body, std::nullopt);
  EXPECT_THAT(status.bodies, IsEmpty());
  EXPECT_THAT(status.message, AllOf(HasSubstr("31"), HasSubstr("47")));
}

TEST(InvalidBoxes, AreNoneWhereAllAreValid) {
  EXPECT_TRUE(find_invalid_boxes({}, {}).ok());
  EXPECT_TRUE(find_invalid_boxes(Ids{4, 5}, std::vector<Aabb>{kGood, Aabb{}}).ok());
  const Aabb denormal = {{std::numeric_limits<float>::denorm_min(), 0, 0}, {-0.0F, 0, 0}};
  EXPECT_TRUE(find_invalid_boxes(Ids{4}, std::vector<Aabb>{denormal}).ok());
}

TEST(InvalidBoxes, NameTheBodyTheAxisAndTheNumbers) {
  const Status reversed = find_invalid_boxes(Ids{3, 4242}, std::vector<Aabb>{kGood, kReversed});
  expect_bodies(reversed, StatusCode::invalid_box, {4242});
  EXPECT_THAT(reversed.message,
              AllOf(HasSubstr("body 4242"), HasSubstr(" y"), HasSubstr("7.5"), HasSubstr("3.25")));

  const Status infinite = find_invalid_boxes(Ids{0}, std::vector<Aabb>{{{0, 0, 0}, {1, 1, kInfinite}}});
  expect_bodies(infinite, StatusCode::invalid_box, {0});
  EXPECT_THAT(infinite.message,
              AllOf(HasSubstr("body 0"), HasSubstr(" z"), HasSubstr("inf"), HasSubstr("not finite")));

  const Status nan = find_invalid_boxes(Ids{0xffffffff}, std::vector<Aabb>{{{kNan, 0, 0}, {1, 1, 1}}});
  expect_bodies(nan, StatusCode::invalid_box, {0xffffffff});
  EXPECT_THAT(nan.message, AllOf(HasSubstr("4294967295"), HasSubstr(" x"), HasSubstr("nan")));
}

TEST(InvalidBoxes, OfBodiesWithoutIdsAreNamedByTheirPlaces) {
  const Status status = find_invalid_boxes({}, std::vector<Aabb>{kGood, kGood, kReversed, kGood, kReversed});
  expect_bodies(status, StatusCode::invalid_box, {2, 4});
  EXPECT_THAT(status.message, AllOf(HasSubstr("body 2"), HasSubstr("body 4")));
}

TEST(InvalidBoxes, AreAllCountedThoughAsManyAreNamedAsAStatusHasRoomFor) {
  const Ids ids = ids_upwards(100, 50);
  const Status status = find_invalid_boxes(ids, std::vector<Aabb>(50, kReversed));
  EXPECT_EQ(status.number, 50U);
  EXPECT_EQ(status.bodies, ids_upwards(100, Status::kMostBodies));
  EXPECT_THAT(status.message,
              AllOf(HasSubstr("body 115"), Not(HasSubstr("body 116")), HasSubstr("and 34 more")));
}

TEST(UnknownBodies, AreThoseThatTheTableDoesNotHoldInTheOrderOfTheCall) {
  const IdTable table = table_with({1, 2, 0xffffffff});
  EXPECT_TRUE(find_unknown(table, {}).ok());
  EXPECT_TRUE(find_unknown(table, Ids{2, 0xffffffff, 1, 2}).ok());
  expect_bodies(find_unknown(table, Ids{77}), StatusCode::unknown_body, {77});
  const Status several = find_unknown(table, Ids{9, 1, 0, 9});
  expect_bodies(several, StatusCode::unknown_body, {9, 0, 9});
  EXPECT_THAT(several.message, HasSubstr("Bodies 9, 0 and 9 are not"));
}

TEST(HeldBodies, AreThoseThatTheTableHolds) {
  const IdTable table = table_with({1, 2, 0xffffffff});
  EXPECT_TRUE(find_held(table, Ids{0, 3}).ok());
  const Status status = find_held(table, Ids{0xffffffff, 3, 1});
  expect_bodies(status, StatusCode::duplicate_body, {0xffffffff, 1});
  EXPECT_THAT(status.message, HasSubstr("Bodies 4294967295 and 1 are"));
  EXPECT_THAT(find_held(table, Ids{2}).message, HasSubstr("Body 2 is"));
}

TEST(BodiesListedTwice, AreEachNamedOnceInTheOrderOfTheCall) {
  EXPECT_TRUE(find_listed_twice({}).ok());
  EXPECT_TRUE(find_listed_twice(Ids{3, 0xffffffff, 0, 2}).ok());
  expect_bodies(find_listed_twice(Ids{5, 5}), StatusCode::duplicate_body, {5});
  expect_bodies(find_listed_twice(Ids{0, 1, 2, 0}), StatusCode::duplicate_body, {0});
  expect_bodies(find_listed_twice(Ids{9, 4, 9, 0xffffffff, 4, 0xffffffff, 9, 1}), StatusCode::duplicate_body,
                {9, 4, 0xffffffff});
}

TEST(BodiesListedTwice, AreAllCountedThoughNotAllAreNamed) {
  Ids ids = ids_upwards(0, 20);
  ids.insert(ids.end(), ids.rbegin(), ids.rend());
  const Status status = find_listed_twice(ids);
  EXPECT_EQ(status.number, 20U);
  EXPECT_EQ(status.bodies, ids_upwards(0, Status::kMostBodies));
  EXPECT_THAT(status.message, AllOf(HasSubstr("0, 1, 2"), HasSubstr("15 and 4 more")));
}

TEST(CapacityCheck, AllowsAsManyAsThereMayBe) {
  EXPECT_TRUE(check_capacity("small", {4096, "", ""}, 4096).ok());
  EXPECT_TRUE(check_capacity("small", {0, "", ""}, 0).ok());
}

TEST(CapacityCheck, SaysHowManyWhyAndWhatToDo) {
  const Status status = check_capacity("small", {4096, "map_bytes", "the map is full"}, 4097);
  EXPECT_EQ(status.code, StatusCode::capacity);
  EXPECT_EQ(status.number, 4097U);
  EXPECT_EQ(status.limit, 4096U);
  EXPECT_EQ(status.setting, "map_bytes");
  EXPECT_THAT(status.message, AllOf(HasSubstr("small"), HasSubstr("4096"), HasSubstr("4097"),
                                    HasSubstr("the map is full"), HasSubstr("raise map_bytes")));
  EXPECT_THAT(check_capacity("small", {1, "", "of reasons"}, 2).message,
              HasSubstr("no setting raises this limit"));
}

TEST(AscendingIds, EachAreAboveTheOneBefore) {
  EXPECT_TRUE(ascends({}));
  EXPECT_TRUE(ascends(Ids{7}));
  EXPECT_TRUE(ascends(Ids{0, 1, 0xffffffff}));
  EXPECT_FALSE(ascends(Ids{1, 1}));
  EXPECT_FALSE(ascends(Ids{0, 2, 1}));
  EXPECT_FALSE(ascends(Ids{0xffffffff, 0}));
}

}  // namespace
}  // namespace cellsweep
