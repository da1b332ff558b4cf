/// @file
/// An engine behind the common checks sees good input only, and all of it.
#include "broadphase/checked_broadphase.h"

#include <gmock/gmock.h>

#include <cfloat>
#include <limits>
#include <string>

namespace cellsweep {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Writes down what reaches it.
class Listener : public CheckedBroadphase {
 public:
  struct Call {
    std::string what;
    std::vector<Slot> slots;
    std::vector<BodyId> ids;  ///< of the slots, as the table has them during the call
    std::vector<Aabb> boxes;
  };

  std::string_view name() const override { return "listener"; }
  Capacity capacity() const override { return limit; }
  Result<PairChanges> update() override { return PairChanges{}; }
  std::span<const Pair> pairs() const override { return {}; }
  const Statistics& statistics() const override { return statistics_; }

  Capacity limit{4, "places", "its places are taken"};
  std::vector<Call> calls;

 protected:
  void apply_insert(std::span<const Slot> slots, std::span<const Aabb> boxes) override {
    write_down("insert", slots, boxes);
  }
  void apply_move(std::span<const Slot> slots, std::span<const Aabb> boxes) override {
    write_down("move", slots, boxes);
  }
  void apply_remove(std::span<const Slot> slots) override { write_down("remove", slots, {}); }

 private:
  void write_down(const char* what, std::span<const Slot> slots, std::span<const Aabb> boxes) {
    Call call{what, {slots.begin(), slots.end()}, {}, {boxes.begin(), boxes.end()}};
    for (const Slot slot : slots) {
      const BodyId id = bodies().id(slot);
      if (bodies().find(id) == slot) call.ids.push_back(id);
    }
    calls.push_back(call);
  }

  Statistics statistics_;
};

constexpr Aabb kUnit{{0, 0, 0}, {1, 1, 1}};

TEST(CheckedBroadphase, HandsOverSlotsOfBodiesThatAreInTheTable) {
  Listener engine;
  ASSERT_TRUE(engine.insert(std::vector<BodyId>{70, 30}, std::vector<Aabb>{kUnit, kUnit}).ok());
  ASSERT_TRUE(engine.move(30, kUnit).ok());
  ASSERT_TRUE(engine.remove(70).ok());
  ASSERT_TRUE(engine.insert(90, kUnit).ok());
  ASSERT_EQ(engine.calls.size(), 4U);
  EXPECT_THAT(engine.calls[0].slots, ElementsAre(0U, 1U));
  EXPECT_THAT(engine.calls[0].ids, ElementsAre(70U, 30U));
  EXPECT_THAT(engine.calls[1].slots, ElementsAre(1U));
  EXPECT_THAT(engine.calls[2].slots, ElementsAre(0U));
  EXPECT_THAT(engine.calls[2].ids, ElementsAre(70U)) << "the body should still be in the table";
  EXPECT_THAT(engine.calls[3].slots, ElementsAre(0U)) << "the slot that 70 left";
  EXPECT_EQ(engine.size(), 2U);
}

TEST(CheckedBroadphase, HandsOverCanonicalBoxes) {
  Listener engine;
  const float denormal = std::numeric_limits<float>::denorm_min();
  ASSERT_TRUE(engine.insert(1, {{-denormal, -0.0F, 1}, {2, denormal, 3}}).ok());
  ASSERT_TRUE(engine.move(1, {{denormal, 0, 0}, {-denormal, 1, 1}}).ok());
  EXPECT_THAT(engine.calls[0].boxes, ElementsAre(Aabb{{0, 0, 1}, {2, 0, 3}}));
  EXPECT_THAT(engine.calls[1].boxes, ElementsAre(Aabb{{0, 0, 0}, {0, 1, 1}}));
}

TEST(CheckedBroadphase, HandsOverNothingOfARefusedCall) {
  Listener engine;
  ASSERT_TRUE(engine.insert(1, kUnit).ok());
  engine.calls.clear();
  const std::vector<BodyId> two = {2, 3};
  EXPECT_FALSE(engine.insert(two, std::vector<Aabb>{kUnit, {{1, 0, 0}, {0, 1, 1}}}).ok());
  EXPECT_FALSE(engine.insert(two, std::vector<Aabb>{kUnit}).ok());
  EXPECT_FALSE(engine.insert(1, kUnit).ok());
  EXPECT_FALSE(engine.move(std::vector<BodyId>{1, 2}, std::vector<Aabb>(2, kUnit)).ok());
  EXPECT_FALSE(engine.remove(std::vector<BodyId>{1, 1}).ok());
  EXPECT_FALSE(engine.remove(two).ok());
  EXPECT_THAT(engine.calls, IsEmpty());
  EXPECT_EQ(engine.size(), 1U);
}

TEST(CheckedBroadphase, CountsTheBodiesAskedForAgainstTheCapacity) {
  Listener engine;
  ASSERT_TRUE(engine.insert(1, kUnit).ok());
  const Status status = engine.insert(std::vector<BodyId>{2, 3, 4, 5}, std::vector<Aabb>(4, kUnit));
  EXPECT_EQ(status.code, StatusCode::capacity);
  EXPECT_EQ(status.number, 5U);
  EXPECT_EQ(status.limit, 4U);
  EXPECT_EQ(status.setting, "places");
  EXPECT_THAT(status.message, testing::AllOf(HasSubstr("listener"), HasSubstr("5"), HasSubstr("4"),
                                             HasSubstr("its places are taken"), HasSubstr("raise places")));
  EXPECT_TRUE(engine.insert(std::vector<BodyId>{2, 3, 4}, std::vector<Aabb>(3, kUnit)).ok());
}

TEST(CheckedBroadphase, NamesNoSettingWhereNoneHelps) {
  Listener engine;
  engine.limit = {0, "", "there is no place at all"};
  const Status status = engine.insert(1, kUnit);
  EXPECT_EQ(status.code, StatusCode::capacity);
  EXPECT_EQ(status.setting, "");
  EXPECT_THAT(status.message, HasSubstr("no setting"));
}

}  // namespace
}  // namespace cellsweep
