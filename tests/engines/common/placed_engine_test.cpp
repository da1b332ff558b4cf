/// @file
/// Slots from anywhere become places below the number of bodies.
#include "engines/common/placed_engine.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "contract/random.h"

namespace cellsweep {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr Aabb box_at(float x) {
  return {{x, 0, 0}, {x + 1, 1, 1}};
}

/// Writes down what reaches it, and which slots the places have at that time.
class Listener : public PlacedEngine {
 public:
  struct Call {
    std::string what;
    std::vector<Slot> places;
    std::vector<Slot> slots;
    std::vector<Aabb> boxes;
  };

  using PlacedEngine::place_count;
  using PlacedEngine::slot;
  using PlacedEngine::slots;

  Capacity capacity() const override { return {}; }

  std::vector<Call> calls;

 protected:
  void apply_remove(std::span<const Slot> places) override { write_down("remove", places, {}); }
  void apply_move(std::span<const Slot> places, std::span<const Aabb> boxes) override {
    write_down("move", places, boxes);
  }
  void apply_insert(std::span<const Slot> places, std::span<const Aabb> boxes) override {
    write_down("insert", places, boxes);
  }
  Result<FoundPairs> find_pairs(Statistics&) override {
    calls.push_back({"find pairs", {}, {}, {}});
    return FoundPairs{};
  }

 private:
  void write_down(const char* what, std::span<const Slot> places, std::span<const Aabb> boxes) {
    Call call{what, {places.begin(), places.end()}, {}, {boxes.begin(), boxes.end()}};
    for (const Slot place : places) call.slots.push_back(slot(place));
    calls.push_back(call);
  }
};

/// A broadphase's side: boxes by slot, and lists of what changed.
class Caller {
 public:
  explicit Caller(Listener& engine) : engine_(engine) {}

  Caller& insert(Slot slot, float x) {
    if (slot >= boxes_.size()) boxes_.resize(slot + 1, kNobody);
    boxes_[slot] = box_at(x);
    inserted_.push_back(slot);
    return *this;
  }
  Caller& move(Slot slot, float x) {
    moved_.push_back(slot);
    boxes_[slot] = box_at(x);
    return *this;
  }
  Caller& remove(Slot slot) {
    removed_.push_back(slot);
    boxes_[slot] = kNobody;
    return *this;
  }

  void update() {
    engine_.calls.clear();
    Statistics statistics;
    bodies_ += inserted_.size() - removed_.size();
    const BodyChanges changes{boxes_, {before_}, removed_, moved_, inserted_, bodies_};
    EXPECT_TRUE(engine_.update(changes, statistics).ok());
    before_ = boxes_;
    removed_.clear();
    moved_.clear();
    inserted_.clear();
  }

 private:
  Listener& engine_;
  std::size_t bodies_ = 0;
  std::vector<Aabb> boxes_;
  std::vector<Aabb> before_;  // the boxes at the last update
  std::vector<Slot> removed_;
  std::vector<Slot> moved_;
  std::vector<Slot> inserted_;
};

class PlacedEngineTest : public testing::Test {
 protected:
  Listener engine_;
  Caller caller_{engine_};
};

TEST_F(PlacedEngineTest, PlacesAreGivenOutInTheOrderOfTheList) {
  caller_.insert(700, 1).insert(3, 2).insert(90'000, 3).update();
  ASSERT_EQ(engine_.calls.size(), 2U);
  EXPECT_EQ(engine_.calls[0].what, "insert");
  EXPECT_THAT(engine_.calls[0].places, ElementsAre(0U, 1U, 2U));
  EXPECT_THAT(engine_.calls[0].slots, ElementsAre(700U, 3U, 90'000U));
  EXPECT_THAT(engine_.calls[0].boxes, ElementsAre(box_at(1), box_at(2), box_at(3)));
  EXPECT_EQ(engine_.calls[1].what, "find pairs");
  EXPECT_EQ(engine_.place_count(), 3U);
}

TEST_F(PlacedEngineTest, NothingIsHandedOverWhereNothingChanged) {
  caller_.update();
  ASSERT_EQ(engine_.calls.size(), 1U);
  EXPECT_EQ(engine_.calls[0].what, "find pairs");
}

TEST_F(PlacedEngineTest, RemovedBodiesComeFirstAndStillHaveTheirSlots) {
  caller_.insert(10, 1).insert(11, 2).insert(12, 3).update();
  caller_.insert(20, 4).move(12, 5).remove(10).remove(11).update();
  ASSERT_EQ(engine_.calls.size(), 4U);
  EXPECT_EQ(engine_.calls[0].what, "remove");
  EXPECT_THAT(engine_.calls[0].places, ElementsAre(0U, 1U));
  EXPECT_THAT(engine_.calls[0].slots, ElementsAre(10U, 11U));
  EXPECT_EQ(engine_.calls[1].what, "move");
  EXPECT_THAT(engine_.calls[1].places, ElementsAre(2U));
  EXPECT_THAT(engine_.calls[1].boxes, ElementsAre(box_at(5)));
  EXPECT_EQ(engine_.calls[2].what, "insert");
  EXPECT_THAT(engine_.calls[2].slots, ElementsAre(20U));
}

TEST_F(PlacedEngineTest, ThePlaceFreedLastIsGivenOutFirst) {
  caller_.insert(10, 1).insert(11, 2).insert(12, 3).insert(13, 4).update();
  caller_.remove(11).remove(13).update();
  EXPECT_EQ(engine_.slot(1), 11U) << "a free place keeps the slot that it had";
  caller_.insert(50, 5).insert(51, 6).insert(52, 7).update();
  EXPECT_THAT(engine_.calls[0].places, ElementsAre(3U, 1U, 4U));
  EXPECT_EQ(engine_.place_count(), 5U);
}

TEST_F(PlacedEngineTest, APlaceMayBeGivenOutInTheUpdateThatFreesIt) {
  caller_.insert(10, 1).update();
  caller_.remove(10).insert(11, 2).update();
  EXPECT_THAT(engine_.calls[1].places, ElementsAre(0U));
  EXPECT_EQ(engine_.slot(0), 11U);
  EXPECT_EQ(engine_.place_count(), 1U);
}

TEST_F(PlacedEngineTest, APairOfPlacesIsAPairOfSlotsInTheirOrder) {
  caller_.insert(700, 1).insert(3, 2).update();
  EXPECT_EQ(engine_.slots(0, 1), (SlotPair{3, 700}));
  EXPECT_EQ(engine_.slots(1, 0), (SlotPair{3, 700}));
}

TEST_F(PlacedEngineTest, AgreesWithAMapOverHundredsOfUpdatesAndWastesNoPlace) {
  contract::Random random(3);
  std::map<Slot, Slot> place_of;
  std::size_t most = 0;
  for (int update = 0; update < 500; ++update) {
    std::set<Slot> touched;
    for (std::size_t calls = random.below(12); calls > 0; --calls) {
      const auto slot = static_cast<Slot>(random.below(40) * 101);
      if (!touched.insert(slot).second) continue;
      if (!place_of.contains(slot)) {
        caller_.insert(slot, 1);
      } else if (random.one_in(2)) {
        caller_.move(slot, 2);
      } else {
        caller_.remove(slot);
      }
    }
    caller_.update();
    for (const Listener::Call& call : engine_.calls) {
      for (std::size_t i = 0; i < call.places.size(); ++i) {
        if (call.what == "insert") place_of[call.slots[i]] = call.places[i];
        ASSERT_EQ(place_of.at(call.slots[i]), call.places[i]) << call.what;
        if (call.what == "remove") place_of.erase(call.slots[i]);
      }
    }
    most = std::max(most, place_of.size());
    std::set<Slot> used;
    for (const auto& [slot, place] : place_of) ASSERT_TRUE(used.insert(place).second && place < most);
    ASSERT_EQ(engine_.place_count(), most) << "a free place was left unused";
  }
}

}  // namespace
}  // namespace cellsweep
