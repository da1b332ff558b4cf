/// @file
/// Calls that every engine must refuse, with the right words, and as if they had never been made.
#include <gmock/gmock.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/effort.h"

namespace cellsweep::contract {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// A call and what the engine must say to it.
struct Refusal {
  std::string name;
  std::function<Status(Broadphase&)> call;
  StatusCode code = StatusCode::ok;
  std::vector<BodyId> bodies;  ///< all that are at fault, in the order of the call
};

/// Row `i` of overlapping unit cubes.
Aabb cube(int i) {
  const float x = 0.75F * static_cast<float>(i);
  return {{x, 0, 0}, {x + 1, 1, 1}};
}

/// Bodies 10, 20 … 60 as of the last update, and calls that no update has seen yet: 70 is new, 20 has moved,
/// 30 is gone, 40 is gone and has come back. Each refusal starts here.
void set_up(CheckedEngine& checked) {
  ASSERT_TRUE(
      checked.insert({10, 20, 30, 40, 50, 60}, {cube(0), cube(1), cube(2), cube(3), cube(4), cube(5)}));
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.insert({70}, {cube(6)}));
  ASSERT_TRUE(checked.move({20}, {cube(5)}));
  ASSERT_TRUE(checked.remove({30}));
  ASSERT_TRUE(checked.remove({40}));
  ASSERT_TRUE(checked.insert({40}, {cube(4)}));
}

/// Goes on after the refusal, so that whatever it left inside the engine shows.
void go_on(CheckedEngine& checked) {
  std::vector<BodyId> added;
  ASSERT_TRUE(checked.add({cube(2), cube(5)}, added));
  // Behind the eight bodies that there were, those that are gone among them.
  ASSERT_EQ(added, (std::vector<BodyId>{8, 9})) << "a refused call used up ids";
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.remove(added));
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.insert({0, 30, 500, 501, 0xffffffff}, {cube(0), cube(1), cube(2), cube(3), cube(4)}));
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.move({10, 20, 40, 50, 60, 70}, {cube(6), cube(5), cube(4), cube(3), cube(2), cube(1)}));
  ASSERT_TRUE(checked.update());
  ASSERT_TRUE(checked.remove(checked.model().ids()));
  ASSERT_TRUE(checked.update());
}

/// The last answer of an engine that never saw a refused call.
Answer spared_answer(const ContractEngine& engine) {
  CheckedEngine spared(engine, "without a refused call");
  set_up(spared);
  go_on(spared);
  return spared.answer();
}

/// Checks that a status names all bodies at fault, by number and in words.
void expect_bodies(const Status& status, const std::vector<BodyId>& bodies) {
  const std::size_t named = std::min(bodies.size(), Status::kMostBodies);
  EXPECT_EQ(status.bodies, std::vector<BodyId>(bodies.begin(), bodies.begin() + named)) << status.message;
  const std::optional<BodyId> first = bodies.empty() ? std::nullopt : std::optional(bodies.front());
  EXPECT_EQ(status.body, first) << status.message;
  if (bodies.empty()) return;
  EXPECT_EQ(status.number, bodies.size()) << status.message;
  for (std::size_t i = 0; i < named; ++i) {
    EXPECT_THAT(status.message, testing::HasSubstr(std::to_string(bodies[i])));
  }
}

void refuse(CheckedEngine& tried, const Refusal& refusal) {
  SCOPED_TRACE(refusal.name);
  Status status;
  ASSERT_TRUE(tried.refuse(refusal.call, status));
  EXPECT_EQ(status.code, refusal.code) << status.message;
  EXPECT_FALSE(status.message.empty());
  expect_bodies(status, refusal.bodies);
}

/// An engine with the refused calls, one after the other, must go on like one that never saw them, in the
/// same order.
void expect_refusals_in_a_row(const ContractEngine& engine, std::span<const Refusal> refusals,
                              const Answer& spared) {
  SCOPED_TRACE(engine.label + " from " + refusals.front().name);
  CheckedEngine tried(engine, refusals.front().name);
  set_up(tried);
  for (const Refusal& refusal : refusals) refuse(tried, refusal);
  go_on(tried);
  EXPECT_EQ(tried.answer(), spared);
}

/// Each refusal on an engine of its own.
void expect_refusals(const ContractEngine& engine, const std::vector<Refusal>& refusals) {
  const Answer spared = spared_answer(engine);
  for (const Refusal& refusal : refusals) expect_refusals_in_a_row(engine, {&refusal, 1}, spared);
}

using RefusalsContract = PerEngine;

/// A box with one fault on one axis.
struct Fault {
  std::string name;
  float min;
  float max;
};

const std::vector<Fault>& faults() {
  static const std::vector<Fault> all = {
      {"NaN below", kNan, 1},
      {"NaN above", 0, kNan},
      {"two NaNs", kNan, kNan},
      {"a negative NaN", -kNan, 1},
      {"infinity above", 0, kInfinity},
      {"minus infinity below", -kInfinity, 1},
      {"infinity at both ends", kInfinity, kInfinity},
      {"all of the axis", -kInfinity, kInfinity},
      {"ends the wrong way round", 1, 0},
      {"ends the wrong way round by one bit", 1 + FLT_EPSILON, 1},
      {"ends the wrong way round around zero", FLT_MIN, -0.0F},
      {"the largest ends the wrong way round", FLT_MAX, -FLT_MAX},
  };
  return all;
}

Aabb faulty_box(const Fault& fault, std::size_t axis) {
  Aabb box = cube(1);
  box.min[axis] = fault.min;
  box.max[axis] = fault.max;
  return box;
}

/// Every call that can carry the box.
std::vector<Refusal> calls_with(const Aabb& bad, const std::string& what) {
  constexpr auto code = StatusCode::invalid_box;
  const std::vector<Aabb> bad_first = {bad, cube(1), cube(2)};
  const std::vector<Aabb> bad_last = {cube(1), cube(2), bad};
  const std::vector<Aabb> bad_twice = {bad, cube(1), bad};
  const std::vector<BodyId> fresh = {500, 501, 502};
  const std::vector<BodyId> held = {10, 20, 70};
  return {
      {"insert of " + what, [=](Broadphase& e) { return e.insert(500, bad); }, code, {500}},
      {"move to " + what, [=](Broadphase& e) { return e.move(10, bad); }, code, {10}},
      {"bulk insert that starts with " + what,
       [=](Broadphase& e) { return e.insert(fresh, bad_first); },
       code,
       {500}},
      {"bulk insert that ends with " + what,
       [=](Broadphase& e) { return e.insert(fresh, bad_last); },
       code,
       {502}},
      {"bulk insert with two of " + what,
       [=](Broadphase& e) { return e.insert(fresh, bad_twice); },
       code,
       {500, 502}},
      {"bulk move that starts with " + what,
       [=](Broadphase& e) { return e.move(held, bad_first); },
       code,
       {10}},
      {"bulk move that ends with " + what, [=](Broadphase& e) { return e.move(held, bad_last); }, code, {70}},
      {"bulk move with two of " + what,
       [=](Broadphase& e) { return e.move(held, bad_twice); },
       code,
       {10, 70}},
  };
}

TEST_P(RefusalsContract, ABadBoxIsRefusedAloneAndAtEitherEndOfABulkCall) {
  const Answer spared = spared_answer(GetParam());
  for (const Fault& fault : faults()) {
    std::vector<Refusal> refusals;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::ranges::move(calls_with(faulty_box(fault, axis), fault.name + " on axis " + std::to_string(axis)),
                        std::back_inserter(refusals));
    }
    expect_refusals_in_a_row(GetParam(), refusals, spared);
    if (HasFailure()) return;
  }
}

/// A bulk call on bodies, each with a good box.
std::function<Status(Broadphase&)> bulk_insert(std::vector<BodyId> ids) {
  return [ids](Broadphase& e) { return e.insert(ids, std::vector<Aabb>(ids.size(), cube(3))); };
}
std::function<Status(Broadphase&)> bulk_move(std::vector<BodyId> ids) {
  return [ids](Broadphase& e) { return e.move(ids, std::vector<Aabb>(ids.size(), cube(3))); };
}
std::function<Status(Broadphase&)> bulk_remove(std::vector<BodyId> ids) {
  return [ids](Broadphase& e) { return e.remove(ids); };
}

TEST_P(RefusalsContract, ABodyThatIsNotThereCannotBeMovedOrRemoved) {
  constexpr auto code = StatusCode::unknown_body;
  const std::vector<Refusal> refusals = {
      {"move of a body never seen", bulk_move({500}), code, {500}},
      {"move of a body removed before the update", bulk_move({30}), code, {30}},
      {"move of body 0", bulk_move({0}), code, {0}},
      {"move of the last id there is", bulk_move({0xffffffff}), code, {0xffffffff}},
      {"bulk move that ends with a body never seen", bulk_move({10, 20, 500}), code, {500}},
      {"bulk move that starts with a body never seen", bulk_move({500, 10, 20}), code, {500}},
      {"remove of a body never seen", bulk_remove({500}), code, {500}},
      {"remove of a body removed before the update", bulk_remove({30}), code, {30}},
      {"remove of body 0", bulk_remove({0}), code, {0}},
      {"remove of the last id there is", bulk_remove({0xffffffff}), code, {0xffffffff}},
      {"bulk remove that ends with a body never seen", bulk_remove({10, 70, 500}), code, {500}},
      {"bulk remove that starts with a body never seen", bulk_remove({500, 10, 70}), code, {500}},
      {"bulk move of more bodies that are not there", bulk_move({500, 10, 30, 0, 20}), code, {500, 30, 0}},
      {"bulk remove of more bodies that are not there",
       bulk_remove({501, 500, 10, 30}),
       code,
       {501, 500, 30}},
  };
  expect_refusals(GetParam(), refusals);
}

TEST_P(RefusalsContract, ABodyThatIsThereCannotBeInsertedAgain) {
  constexpr auto code = StatusCode::duplicate_body;
  const std::vector<Refusal> refusals = {
      {"insert of a body of the last update", bulk_insert({10}), code, {10}},
      {"insert of a body that has moved", bulk_insert({20}), code, {20}},
      {"insert of a body that no update has seen", bulk_insert({70}), code, {70}},
      {"insert of a body that went and came back", bulk_insert({40}), code, {40}},
      {"bulk insert of more bodies that are held", bulk_insert({70, 500, 20, 501, 10}), code, {70, 20, 10}},
      {"bulk insert that ends with a body held", bulk_insert({500, 501, 10}), code, {10}},
      {"bulk insert that starts with a body held", bulk_insert({10, 500, 501}), code, {10}},
  };
  expect_refusals(GetParam(), refusals);
}

TEST_P(RefusalsContract, ABodyCannotBeInsertedOrRemovedTwiceInOneCall) {
  constexpr auto code = StatusCode::duplicate_body;
  const std::vector<Refusal> refusals = {
      {"insert of one body twice", bulk_insert({500, 500}), code, {500}},
      {"insert of one body twice, apart", bulk_insert({501, 500, 502, 501}), code, {501}},
      {"insert of two bodies twice", bulk_insert({501, 501, 7, 500, 500}), code, {501, 500}},
      {"remove of one body twice", bulk_remove({10, 10}), code, {10}},
      {"remove of one body twice, apart", bulk_remove({70, 10, 20, 70}), code, {70}},
      {"remove of two bodies twice", bulk_remove({70, 70, 20, 10, 10}), code, {70, 10}},
  };
  expect_refusals(GetParam(), refusals);
}

/// A bulk call with ids and boxes that differ in number.
using BulkCall = Status (Broadphase::*)(std::span<const BodyId>, std::span<const Aabb>);

Refusal uneven(const std::string& name, BulkCall call, std::vector<BodyId> ids, std::size_t boxes) {
  return {name + " of " + std::to_string(ids.size()) + " ids with " + std::to_string(boxes) + " boxes",
          [=](Broadphase& e) { return (e.*call)(ids, std::vector<Aabb>(boxes, cube(3))); },
          StatusCode::bad_input,
          {}};
}

TEST_P(RefusalsContract, EveryIdNeedsABoxAndEveryBoxAnId) {
  constexpr BulkCall insert = &Broadphase::insert;
  constexpr BulkCall move = &Broadphase::move;
  const std::vector<Refusal> refusals = {
      uneven("insert", insert, {500, 501, 502}, 7),
      uneven("insert", insert, {500, 501}, 1),
      uneven("insert", insert, {500}, 0),
      uneven("insert", insert, {}, 1),
      uneven("move", move, {10, 20, 70}, 7),
      uneven("move", move, {10, 20}, 1),
      uneven("move", move, {10}, 0),
      uneven("move", move, {}, 1),
  };
  expect_refusals(GetParam(), refusals);
}

TEST_P(RefusalsContract, TheWordsForSpansOfDifferentLengthNameBothLengths) {
  Broadphase engine = make(GetParam());
  const Status status = engine.insert(std::vector<BodyId>(31), std::vector<Aabb>(47));
  EXPECT_EQ(status.code, StatusCode::bad_input);
  EXPECT_THAT(status.message, testing::AllOf(testing::HasSubstr("31"), testing::HasSubstr("47")));
}

TEST_P(RefusalsContract, AddingNeedsGoodBoxesAndAPlaceForEachId) {
  std::vector<BodyId> ids(3, 77);
  const std::vector<Aabb> bad = {cube(1), faulty_box(faults()[0], 1), cube(2)};
  CheckedEngine tried(GetParam(), "refused to add");
  set_up(tried);
  Status status;
  ASSERT_TRUE(tried.refuse([&](Broadphase& e) { return e.add(bad, ids); }, status));
  EXPECT_EQ(status.code, StatusCode::invalid_box) << status.message;
  EXPECT_EQ(status.number, 1U);
  ASSERT_TRUE(tried.refuse([&](Broadphase& e) { return e.add(bad[1]).status(); }, status));
  EXPECT_EQ(status.code, StatusCode::invalid_box) << status.message;
  for (const std::size_t length : {0U, 1U, 2U, 4U, 9U}) {
    const std::vector<Aabb> boxes(length, cube(3));
    ASSERT_TRUE(tried.refuse([&](Broadphase& e) { return e.add(boxes, ids); }, status));
    EXPECT_EQ(status.code, StatusCode::bad_input) << status.message;
  }
  EXPECT_EQ(ids, std::vector<BodyId>(3, 77)) << "a refused call handed out ids";
  go_on(tried);
  EXPECT_EQ(tried.answer(), spared_answer(GetParam()));
}

/// Some thousand bodies in a row, where the engine is made for that many, and calls on all of them.
class BatchRefusalsContract : public PerEngine {
 protected:
  void SetUp() override {
    constexpr std::size_t kMany = 100'000;
    constexpr std::size_t kSome = 500;
    ids_.resize(checked_.capacity() < kMany ? std::min(kSome, checked_.capacity()) : effort(3000, 500));
    for (std::size_t i = 0; i < ids_.size(); ++i) {
      ids_[i] = static_cast<BodyId>(7 * i + 3);
      boxes_.push_back(cube(static_cast<int>(i)));
    }
  }

  /// Refused calls on all bodies, of which those in these places have a bad box.
  void expect_bad_boxes(const std::vector<std::size_t>& places, BulkCall call) {
    std::vector<Aabb> boxes = boxes_;
    std::vector<BodyId> bodies;
    for (const std::size_t place : places) {
      boxes[place] = faulty_box(faults()[place % faults().size()], place % 3);
      bodies.push_back(ids_[place]);
    }
    refuse(checked_,
           {std::to_string(places.size()) + " bad boxes of " + std::to_string(ids_.size()),
            [&](Broadphase& e) { return (e.*call)(ids_, boxes); }, StatusCode::invalid_box, bodies});
  }

  void expect_bad_boxes_everywhere(BulkCall call) {
    const std::size_t last = ids_.size() - 1;
    for (const std::size_t place : {std::size_t{0}, last / 3, last / 2, last - 1, last}) {
      expect_bad_boxes({place}, call);
    }
    expect_bad_boxes(spread(Status::kMostBodies), call);
    expect_bad_boxes(spread(Status::kMostBodies + 1), call);
    expect_bad_boxes(spread(ids_.size()), call);
  }

  /// So many places, ascending, from the first to the last.
  std::vector<std::size_t> spread(std::size_t count) const {
    count = std::min(count, ids_.size());
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < count; ++i) places.push_back(i * (ids_.size() - 1) / (count - 1));
    return places;
  }

  CheckedEngine checked_{GetParam(), "a large batch"};
  std::vector<BodyId> ids_;
  std::vector<Aabb> boxes_;
};

TEST_P(BatchRefusalsContract, OneBadBoxRefusesTheWholeBatchAndAllThatAreBadAreNamed) {
  expect_bad_boxes_everywhere(&Broadphase::insert);
  ASSERT_TRUE(checked_.update());
  ASSERT_TRUE(checked_.insert(ids_, boxes_));
  expect_bad_boxes_everywhere(&Broadphase::move);
  ASSERT_TRUE(checked_.update());
  expect_bad_boxes_everywhere(&Broadphase::move);
  ASSERT_TRUE(checked_.update());
  EXPECT_TRUE(checked_.answer().began.empty() && checked_.answer().ended.empty());
}

TEST_P(BatchRefusalsContract, BodiesThatAreNotThereAreNamedUpToSixteenAndCountedAll) {
  ASSERT_TRUE(checked_.insert(ids_, boxes_));
  ASSERT_TRUE(checked_.update());
  std::vector<BodyId> asked = ids_;
  std::vector<BodyId> unknown;
  for (const std::size_t place : spread(100)) {
    asked[place] += 1;
    unknown.push_back(asked[place]);
  }
  constexpr auto code = StatusCode::unknown_body;
  refuse(checked_, {"move", [&](Broadphase& e) { return e.move(asked, boxes_); }, code, unknown});
  refuse(checked_, {"remove", [&](Broadphase& e) { return e.remove(asked); }, code, unknown});
  ASSERT_TRUE(checked_.update());
}

INSTANTIATE_TEST_SUITE_P(Engines, BatchRefusalsContract, all_engines(), engine_label);

INSTANTIATE_TEST_SUITE_P(Engines, RefusalsContract, all_engines(), engine_label);

}  // namespace
}  // namespace cellsweep::contract
