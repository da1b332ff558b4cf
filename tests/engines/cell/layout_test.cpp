/// @file
/// Local-store layouts: the sum, what fits, and the words.
#include "engines/cell/ppu/layout.h"

#include <gmock/gmock.h>

namespace cellsweep::cell {
namespace {

std::vector<LocalStorePart> ten_bytes_each(std::uint64_t bodies) {
  return {{"things", 10 * bodies}};
}

constexpr LocalStoreBudget kBudget{1000, 400, 100, 200};

TEST(LocalStoreLayout, AddsItsPartsUp) {
  const LocalStoreMap map = make_local_store_map("e", kBudget, ten_bytes_each, 7);
  EXPECT_EQ(map.used(), 770U);
  EXPECT_TRUE(map.fits());
  EXPECT_FALSE(make_local_store_map("e", kBudget, ten_bytes_each, 31).fits());
}

TEST(LocalStoreLayout, FitsAsManyBodiesAsThereIsRoomForAndNotOneMore) {
  EXPECT_EQ(bodies_that_fit_local_store(kBudget, ten_bytes_each, 5000), 30U);
  EXPECT_EQ(bodies_that_fit_local_store(kBudget, ten_bytes_each, 12), 12U);
  EXPECT_EQ(bodies_that_fit_local_store({650, 400, 100, 200}, ten_bytes_each, 5000), 0U);
}

TEST(LocalStoreLayout, WithoutALimitEverythingFits) {
  EXPECT_EQ(bodies_that_fit_local_store({0, 400, 100, 200}, ten_bytes_each, 5000), 5000U);
}

TEST(LocalStoreLayout, SaysWhatFillsTheLocalStoreAndHowFarItIsOver) {
  const Capacity capacity = *local_store_capacity("e", kBudget, ten_bytes_each, 5000, "no more names");
  EXPECT_EQ(capacity.bodies, 30U);
  EXPECT_EQ(capacity.setting, "local_store");
  EXPECT_THAT(capacity.reason, testing::HasSubstr("code 400, data 100, stack 200, things 310"));
  EXPECT_THAT(capacity.reason, testing::HasSubstr("10 too many"));
}

TEST(LocalStoreLayout, GivesTheOtherReasonWhereTheLocalStoreIsLargeEnough) {
  const Capacity capacity = *local_store_capacity("e", kBudget, ten_bytes_each, 20, "no more names");
  EXPECT_EQ(capacity.bodies, 20U);
  EXPECT_EQ(capacity.setting, "");
  EXPECT_EQ(capacity.reason, "no more names");
}

TEST(LocalStoreLayout, IsRefusedWithItsMapWithoutRoomForOneBody) {
  const auto none = local_store_capacity("e", {705, 400, 100, 200}, ten_bytes_each, 20, "no more names");
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(none.status().code, StatusCode::capacity);
  EXPECT_EQ(none.status().setting, "local_store");
  EXPECT_EQ(none.status().number, 710U);
  EXPECT_EQ(none.status().limit, 705U);
  EXPECT_THAT(none.status().message, testing::HasSubstr("e cannot hold a single body"));
  EXPECT_THAT(none.status().message, testing::HasSubstr("things 10"));
}

}  // namespace
}  // namespace cellsweep::cell
