/// @file
/// What an engine says it holds, it holds; one body more is refused and nothing changes.
#include <gmock/gmock.h>

#include <numeric>
#include <span>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"

namespace cellsweep::contract {
namespace {

/// Capacities up to this many bodies are filled body by body.
constexpr std::size_t kFillable = 2000;
/// Capacities up to this many bodies are overrun by one call on an empty engine, which costs little.
constexpr std::size_t kListable = 2'000'000;

std::vector<BodyId> ids_from(BodyId first, std::size_t count) {
  std::vector<BodyId> ids(count);
  std::iota(ids.begin(), ids.end(), first);
  return ids;
}

/// A row of cubes; each touches the next.
std::vector<Aabb> row(std::size_t count) {
  std::vector<Aabb> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<float>(i);
    boxes.push_back({{x, 0, 0}, {x + 1, 1, 1}});
  }
  return boxes;
}

/// Checks the words and numbers of a refusal for want of room.
void expect_capacity_status(const Status& status, const Capacity& capacity) {
  EXPECT_EQ(status.code, StatusCode::capacity) << status.message;
  EXPECT_GT(status.number, status.limit);
  EXPECT_THAT(status.message, testing::HasSubstr(std::to_string(status.number)));
  EXPECT_THAT(status.message, testing::HasSubstr(std::to_string(status.limit)));
  EXPECT_EQ(status.setting, capacity.setting);
  EXPECT_THAT(status.message, testing::HasSubstr(capacity.setting));
}

/// Bodies 0, 1, 2 … up to the capacity, seen by an update.
class FullEngine {
 public:
  explicit FullEngine(const ContractEngine& engine) : checked_(engine, "filled to capacity") {}

  CheckedEngine& fill() {
    const std::size_t count = checked_.capacity();
    EXPECT_TRUE(checked_.insert(ids_from(0, count), row(count)));
    EXPECT_TRUE(checked_.update());
    return checked_;
  }

 private:
  CheckedEngine checked_;
};

/// Engines with as little capacity as their settings allow.
class CapacityContract : public PerEngine {
 protected:
  void SetUp() override {
    engine_ = GetParam();
    if (engine_.shrink) engine_.make = engine_.shrink();
    capacity_ = make(engine_).capacity();
    if (capacity_.bodies > kFillable)
      GTEST_SKIP() << "takes " << capacity_.bodies << " bodies, too many to fill";
  }

  ContractEngine engine_;
  Capacity capacity_;
};

TEST_P(CapacityContract, AFullEngineRefusesOneMoreAndGoesOnAsBefore) {
  FullEngine full(engine_);
  CheckedEngine& checked = full.fill();
  Status status;
  ASSERT_TRUE(checked.refuse([](Broadphase& e) { return e.insert(0xffffffff, row(1)[0]); }, status));
  expect_capacity_status(status, capacity_);
  ASSERT_TRUE(checked.update());
  EXPECT_TRUE(checked.answer().began.empty() && checked.answer().ended.empty());
  ASSERT_TRUE(checked.move({0}, row(1)));
  ASSERT_TRUE(checked.update());
}

TEST_P(CapacityContract, ABulkInsertThatFitsInPartIsRefusedWhole) {
  const std::size_t half = static_cast<std::size_t>(capacity_.bodies) / 2;
  CheckedEngine checked(engine_, "half full");
  ASSERT_TRUE(checked.insert(ids_from(0, half), row(half)));
  ASSERT_TRUE(checked.update());
  const std::size_t too_many = static_cast<std::size_t>(capacity_.bodies) - half + 1;
  const std::vector<BodyId> ids = ids_from(1'000'000, too_many);
  Status status;
  ASSERT_TRUE(checked.refuse([&](Broadphase& e) { return e.insert(ids, row(too_many)); }, status));
  expect_capacity_status(status, capacity_);
  ASSERT_TRUE(checked.update());
  const std::vector<BodyId> fewer(ids.begin(), ids.end() - 1);
  ASSERT_TRUE(checked.insert(fewer, row(too_many - 1)));
  ASSERT_TRUE(checked.update());
}

TEST_P(CapacityContract, AFullEngineAddsNoBodyAndHandsOutNoId) {
  FullEngine full(engine_);
  CheckedEngine& checked = full.fill();
  Status status;
  BodyId id = 77;
  ASSERT_TRUE(checked.refuse([](Broadphase& e) { return e.add(row(1)[0]).status(); }, status));
  expect_capacity_status(status, capacity_);
  ASSERT_TRUE(checked.refuse([&](Broadphase& e) { return e.add(row(1), std::span(&id, 1)); }, status));
  expect_capacity_status(status, capacity_);
  EXPECT_EQ(id, 77U);
  ASSERT_TRUE(checked.update());
}

TEST_P(CapacityContract, ARemovedBodyMakesRoomBeforeTheNextUpdate) {
  FullEngine full(engine_);
  CheckedEngine& checked = full.fill();
  for (BodyId round = 0; round < 3; ++round) {
    ASSERT_TRUE(checked.remove({round}));
    ASSERT_TRUE(checked.insert({1'000'000 + round}, row(1)));
    Status status;
    ASSERT_TRUE(checked.refuse([](Broadphase& e) { return e.insert(0xffffffff, row(1)[0]); }, status));
    expect_capacity_status(status, capacity_);
    ASSERT_TRUE(checked.update());
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, CapacityContract, all_engines(), engine_label);

using StatedCapacityContract = PerEngine;

TEST_P(StatedCapacityContract, ItIsMoreThanNothingAndSaysWhy) {
  const Capacity capacity = make(GetParam()).capacity();
  EXPECT_GT(capacity.bodies, 0U);
  EXPECT_FALSE(capacity.reason.empty());
}

TEST_P(StatedCapacityContract, OneBodyMoreInOneCallIsRefusedBeforeAnyWork) {
  CheckedEngine checked(GetParam(), "empty");
  const Capacity capacity = checked.engine().capacity();
  if (capacity.bodies > kListable) GTEST_SKIP() << "takes " << capacity.bodies << " bodies, too many to list";
  const std::size_t too_many = checked.capacity() + 1;
  Status status;
  ASSERT_TRUE(
      checked.refuse([&](Broadphase& e) { return e.insert(ids_from(0, too_many), row(too_many)); }, status));
  expect_capacity_status(status, capacity);
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.insert({0, 1}, row(2)));
  ASSERT_TRUE(checked.update());
}

INSTANTIATE_TEST_SUITE_P(Engines, StatedCapacityContract, all_engines(), engine_label);

}  // namespace
}  // namespace cellsweep::contract
