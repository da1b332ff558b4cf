/// @file
/// Statuses and results: codes, sentences, and the numbers behind them.
#include "cellsweep/status.h"

#include <gmock/gmock.h>

#include <memory>
#include <numeric>
#include <string>
#include <vector>

namespace cellsweep {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Status, IsGoodAtFirst) {
  const Status status;
  EXPECT_TRUE(status.ok());
  EXPECT_EQ(status.message, "");
  EXPECT_EQ(status.body, std::nullopt);
  EXPECT_THAT(status.bodies, IsEmpty());
}

TEST(Status, HoldsWhatItIsMadeOf) {
  const Status option = Status::bad_option("threads", "Too many.", 9, 8);
  EXPECT_FALSE(option.ok());
  EXPECT_EQ(option.code, StatusCode::bad_option);
  EXPECT_EQ(option.setting, "threads");
  EXPECT_EQ(option.message, "Too many.");
  EXPECT_EQ(option.number, 9U);
  EXPECT_EQ(option.limit, 8U);
  EXPECT_EQ(option.body, std::nullopt);

  const Status capacity = Status::over_capacity("Full.", 11, 10, "map_bytes");
  EXPECT_EQ(capacity.code, StatusCode::capacity);
  EXPECT_EQ(capacity.number, 11U);
  EXPECT_EQ(capacity.limit, 10U);
  EXPECT_EQ(capacity.setting, "map_bytes");
  EXPECT_EQ(Status::over_capacity("Full.", 11, 10).setting, "");

  const Status input = Status::bad_input("No.", "frames", 3, 4);
  EXPECT_EQ(input.code, StatusCode::bad_input);
  EXPECT_EQ(input.setting, "frames");
  EXPECT_EQ(input.number, 3U);
  EXPECT_EQ(input.limit, 4U);

  const Status spe = Status::spe_failed("Gone.", 5);
  EXPECT_EQ(spe.code, StatusCode::spe_failed);
  EXPECT_EQ(spe.number, 5U);
  EXPECT_EQ(spe.message, "Gone.");
}

TEST(Status, NamesTheFirstBodiesAtFaultAndCountsThemAll) {
  std::vector<BodyId> ids(40);
  std::iota(ids.begin(), ids.end(), BodyId{7});
  const Status many = Status::bad_bodies(StatusCode::unknown_body, "Who?", ids);
  EXPECT_EQ(many.code, StatusCode::unknown_body);
  EXPECT_EQ(many.message, "Who?");
  EXPECT_EQ(many.body, 7U);
  EXPECT_EQ(many.number, 40U);
  ids.resize(Status::kMostBodies);
  EXPECT_EQ(many.bodies, ids);
  const Status one = Status::bad_bodies(StatusCode::duplicate_body, "Twice.", {ids.data(), 1});
  EXPECT_THAT(one.bodies, ElementsAre(7U));
  EXPECT_EQ(one.number, 1U);
}

TEST(Result, HoldsAValueOrSaysWhyThereIsNone) {
  Result<std::string> good(std::string("value"));
  ASSERT_TRUE(good.ok());
  EXPECT_TRUE(static_cast<bool>(good));
  EXPECT_TRUE(good.status().ok());
  EXPECT_EQ(*good, "value");
  EXPECT_EQ(good->size(), 5U);
  *good += '!';
  EXPECT_EQ(*std::as_const(good), "value!");
  EXPECT_EQ(std::as_const(good)->size(), 6U);

  const Result<std::string> bad(Status::bad_input("No."));
  EXPECT_FALSE(bad.ok());
  EXPECT_FALSE(static_cast<bool>(bad));
  EXPECT_EQ(bad.status().code, StatusCode::bad_input);
  EXPECT_EQ(bad.status().message, "No.");
}

TEST(Result, MayHoldWhatCanOnlyBeMoved) {
  Result<std::unique_ptr<int>> made(std::make_unique<int>(3));
  ASSERT_TRUE(made.ok());
  const std::unique_ptr<int> taken = std::move(*made);
  EXPECT_EQ(*taken, 3);
}

}  // namespace
}  // namespace cellsweep
