/// @file
/// What is refused through the face for C: with a number, a sentence, and nothing changed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "bindings/c/c_world.h"

namespace cellsweep::c {
namespace {

using testing::HasSubstr;

const cellsweep_boxes kNoBoxes = cellsweep_boxes_of(nullptr, 0);
const cellsweep_ids kNoIds = cellsweep_ids_of(nullptr, 0);
const cellsweep_boxes kOneBox = cellsweep_boxes_of(&kCube, 1);

template <class Call>
void expect_refused(const Call& call, cellsweep_status status, const std::string& words) {
  cellsweep_failure why;
  std::memset(&why, 0x5a, sizeof why);
  EXPECT_EQ(call(&why), status) << words;
  EXPECT_EQ(why.status, status);
  EXPECT_THAT(why.message, HasSubstr(words));
  EXPECT_EQ(call(nullptr), status) << "and without a place for the sentence";
}

TEST(CRefusals, NullWhereSomethingIsNeeded) {
  const World world = make_cubes(2);
  const PairList list = make_list();
  const Answers answers = make_answers();
  const cellsweep_region region = cellsweep_box_region(kCube);
  const cellsweep_path path = cellsweep_moving_box(kCube, std::vector<double>{1, 0, 0}.data());
  bool any = false;
  cellsweep_first_touch first;
  cellsweep_changes changes = {nullptr, 0, nullptr, 0};
  std::size_t count = 0;
  const cellsweep_pair* pairs = nullptr;
  cellsweep_filter filter;
  using Why = cellsweep_failure*;
  cellsweep_broadphase* const w = world.get();
  const auto none = [](const auto& call, const char* name) {
    expect_refused(call, CELLSWEEP_BAD_INPUT, std::string("NULL was given for `") + name + "`");
  };
  const auto no_filters = cellsweep_no_filters();
  none([&](Why f) { return cellsweep_create(nullptr, nullptr, f); }, "made");
  none(
      [&](Why f) {
        cellsweep_broadphase* m;
        return cellsweep_create_engine(nullptr, nullptr, 0, &m, f);
      },
      "engine");
  none(
      [&](Why f) {
        cellsweep_broadphase* m;
        return cellsweep_create_engine("stream", nullptr, 1, &m, f);
      },
      "settings");
  none([&](Why f) { return cellsweep_create_engine("stream", nullptr, 0, nullptr, f); }, "made");
  none([&](Why f) { return cellsweep_insert(nullptr, kNoIds, kNoBoxes, no_filters, f); }, "broadphase");
  none([&](Why f) { return cellsweep_insert(w, cellsweep_ids_of(nullptr, 1), kOneBox, no_filters, f); },
       "ids");
  none([&](Why f) { return cellsweep_add(nullptr, kNoBoxes, nullptr, f); }, "broadphase");
  none([&](Why f) { return cellsweep_add(w, kOneBox, nullptr, f); }, "ids");
  none([&](Why f) { return cellsweep_move(nullptr, kNoIds, kNoBoxes, f); }, "broadphase");
  none([&](Why f) { return cellsweep_set_filters(nullptr, kNoIds, no_filters, f); }, "broadphase");
  none([&](Why f) { return cellsweep_set_filters(w, kNoIds, cellsweep_filters_of(nullptr, 1), f); },
       "filters");
  none([&](Why f) { return cellsweep_remove(nullptr, kNoIds, f); }, "broadphase");
  none([&](Why f) { return cellsweep_update(nullptr, nullptr, f); }, "broadphase");
  none([&](Why f) { return cellsweep_pairs(nullptr, &pairs, &count, f); }, "broadphase");
  none([&](Why f) { return cellsweep_pairs(w, nullptr, &count, f); }, "pairs");
  none([&](Why f) { return cellsweep_pairs(w, &pairs, nullptr, f); }, "count");
  none([&](Why f) { return cellsweep_read_boxes(nullptr, kNoIds, nullptr, f); }, "broadphase");
  none([&](Why f) { return cellsweep_read_boxes(w, cellsweep_ids_of(nullptr, 1), nullptr, f); }, "boxes");
  none([&](Why f) { return cellsweep_filter_of(nullptr, 1, &filter, f); }, "broadphase");
  none([&](Why f) { return cellsweep_filter_of(w, 1, nullptr, f); }, "filter");
  none([&](Why f) { return cellsweep_history_create(1, nullptr, f); }, "made");
  none([&](Why f) { return cellsweep_history_record(nullptr, 1, &changes, f); }, "history");
  none([&](Why f) { return cellsweep_history_since(nullptr, 1, &changes, f); }, "history");
  none([&](Why f) { return cellsweep_pair_list_create(nullptr, f); }, "made");
  none([&](Why f) { return cellsweep_find_pairs(kOneBox, nullptr, nullptr, f); }, "list");
  none([&](Why f) { return cellsweep_find_pairs_between(kOneBox, kOneBox, nullptr, nullptr, f); }, "list");
  none([&](Why f) { return cellsweep_count_pairs(kOneBox, nullptr, nullptr, f); }, "count");
  none([&](Why f) { return cellsweep_count_pairs_between(kOneBox, kOneBox, nullptr, nullptr, f); }, "count");
  none([&](Why f) { return cellsweep_visit_pairs(kOneBox, nullptr, nullptr, nullptr, f); }, "visit");
  none([&](Why f) { return cellsweep_visit_pairs_between(kOneBox, kOneBox, nullptr, nullptr, nullptr, f); },
       "visit");
  none([&](Why f) { return cellsweep_prepare_queries(nullptr, f); }, "broadphase");
  none([&](Why f) { return cellsweep_answers_create(nullptr, f); }, "made");
  none([&](Why f) { return cellsweep_find_overlaps(nullptr, &region, 1, nullptr, answers.get(), f); },
       "broadphase");
  none([&](Why f) { return cellsweep_find_overlaps(w, nullptr, 1, nullptr, answers.get(), f); }, "regions");
  none([&](Why f) { return cellsweep_find_overlaps(w, &region, 1, nullptr, nullptr, f); }, "answers");
  none([&](Why f) { return cellsweep_find_touches(w, nullptr, 1, nullptr, answers.get(), f); }, "paths");
  none([&](Why f) { return cellsweep_find_nearest(w, nullptr, 1, 1, 1, nullptr, answers.get(), f); },
       "boxes");
  none([&](Why f) { return cellsweep_find_within(w, nullptr, 1, nullptr, answers.get(), f); }, "regions");
  none([&](Why f) { return cellsweep_any_overlaps(w, &region, 1, nullptr, nullptr, f); }, "any");
  none([&](Why f) { return cellsweep_any_overlaps(w, nullptr, 1, nullptr, &any, f); }, "regions");
  none([&](Why f) { return cellsweep_any_touches(w, &path, 1, nullptr, nullptr, f); }, "any");
  none([&](Why f) { return cellsweep_first_touches(w, nullptr, 1, nullptr, &first, f); }, "paths");
  none([&](Why f) { return cellsweep_first_touches(w, &path, 1, nullptr, nullptr, f); }, "first");
  none([&](Why f) { return cellsweep_visit_overlaps(w, &region, nullptr, nullptr, nullptr, f); }, "visit");
  none([&](Why f) { return cellsweep_visit_touches(w, nullptr, nullptr, nullptr, nullptr, f); }, "path");
  none([&](Why f) { return cellsweep_find_pairs_of(nullptr, kNoIds, list.get(), f); }, "broadphase");
  none([&](Why f) { return cellsweep_find_pairs_of(w, kNoIds, nullptr, f); }, "list");
  none([&](Why f) { return cellsweep_set_allocator(nullptr, f); }, "allocator");
  EXPECT_EQ(cellsweep_size(w), 2U);
}

TEST(CRefusals, WhatReturnsNoStatusReturnsNothingForNull) {
  EXPECT_EQ(cellsweep_engine_name(nullptr), nullptr);
  EXPECT_EQ(cellsweep_capacity(nullptr), 0U);
  EXPECT_EQ(cellsweep_size(nullptr), 0U);
  EXPECT_FALSE(cellsweep_contains(nullptr, 0));
  EXPECT_EQ(cellsweep_statistics_of(nullptr).updates, 0U);
  EXPECT_EQ(cellsweep_phase_at(nullptr, 0).name, nullptr);
  EXPECT_EQ(cellsweep_counter_at(nullptr, 0).name, nullptr);
  EXPECT_EQ(cellsweep_engine_at(1000), nullptr);
  EXPECT_EQ(cellsweep_engine_summary(1000), nullptr);
  std::size_t count = 1;
  EXPECT_EQ(cellsweep_listed_pairs(nullptr, &count), nullptr);
  EXPECT_EQ(count, 0U);
  EXPECT_EQ(cellsweep_bodies(nullptr, 0, &count), nullptr);
  cellsweep_destroy(nullptr);
  cellsweep_history_destroy(nullptr);
  cellsweep_pair_list_destroy(nullptr);
  cellsweep_answers_destroy(nullptr);
}

TEST(CRefusals, OfBodiesNameThem) {
  const World world = make_cubes(3);
  const std::vector<BodyId> ids = {7, 8, 1};
  cellsweep_failure why;
  EXPECT_EQ(cellsweep_remove(world.get(), ids_in(ids), &why), CELLSWEEP_UNKNOWN_BODY);
  ASSERT_EQ(why.body_count, 2U);
  EXPECT_EQ(why.bodies[0], 7U);
  EXPECT_EQ(why.bodies[1], 8U);
  EXPECT_EQ(why.number, 2U);
  EXPECT_THAT(why.message, HasSubstr("Bodies 7 and 8"));
  EXPECT_EQ(cellsweep_size(world.get()), 3U);
  cellsweep_filter filter;
  EXPECT_EQ(cellsweep_filter_of(world.get(), 9, &filter, &why), CELLSWEEP_UNKNOWN_BODY);
  EXPECT_EQ(why.bodies[0], 9U);
}

TEST(CRefusals, ASentenceThatIsTooLongIsCut) {
  cellsweep_broadphase* made = nullptr;
  cellsweep_failure why;
  EXPECT_EQ(cellsweep_create_engine(std::string(5000, 'x').c_str(), nullptr, 0, &made, &why),
            CELLSWEEP_BAD_OPTION);
  EXPECT_EQ(std::strlen(why.message), sizeof why.message - 1);
  EXPECT_THAT(why.message, testing::EndsWith("x..."));
  EXPECT_EQ(made, nullptr);
}

TEST(CRefusals, OfSettingsNameThem) {
  cellsweep_broadphase* made = nullptr;
  cellsweep_stream_options options = {};
  expect_refused([&](cellsweep_failure* why) { return cellsweep_create(&options, &made, why); },
                 CELLSWEEP_BAD_OPTION, "`size` is 0");
  options.size = sizeof options;
  options.margin = NAN;
  cellsweep_failure why;
  EXPECT_EQ(cellsweep_create(&options, &made, &why), CELLSWEEP_BAD_OPTION);
  EXPECT_STREQ(why.setting, "margin");
  options.margin = 0;
  options.isa = 77;
  EXPECT_EQ(cellsweep_create(&options, &made, &why), CELLSWEEP_BAD_OPTION);
  EXPECT_STREQ(why.setting, "isa");
  options.isa = CELLSWEEP_ISA_BEST;
  const cellsweep_executor executor = {};
  options.executor = &executor;
  EXPECT_EQ(cellsweep_create(&options, &made, &why), CELLSWEEP_BAD_OPTION);
  EXPECT_STREQ(why.setting, "executor");
  const cellsweep_setting setting = {"margin", nullptr};
  EXPECT_EQ(cellsweep_create_engine("stream", &setting, 1, &made, &why), CELLSWEEP_BAD_INPUT);
  EXPECT_EQ(made, nullptr);
}

TEST(CRefusals, BoxesOfNoKind) {
  const World world = make_world();
  cellsweep_boxes boxes = kOneBox;
  boxes.axes = 4;
  uint32_t id = 0;
  expect_refused([&](cellsweep_failure* why) { return cellsweep_add(world.get(), boxes, &id, why); },
                 CELLSWEEP_BAD_INPUT, "2 or 3 axes, not 4");
  boxes = kOneBox;
  boxes.number = 5;
  expect_refused([&](cellsweep_failure* why) { return cellsweep_add(world.get(), boxes, &id, why); },
                 CELLSWEEP_BAD_INPUT, "no kind 5 of numbers");
  expect_refused(
      [&](cellsweep_failure* why) {
        return cellsweep_add(world.get(), cellsweep_boxes_of(nullptr, 1), &id, why);
      },
      CELLSWEEP_BAD_INPUT, "no address");
}

TEST(CRefusals, AnswersStayUnlessThereAreOthers) {
  const World world = make_cubes(3);
  const Answers answers = make_answers();
  cellsweep_region region = cellsweep_box_region(kCube);
  std::size_t count = 0;
  ASSERT_EQ(cellsweep_find_overlaps(world.get(), &region, 1, nullptr, answers.get(), nullptr), CELLSWEEP_OK);
  region.distance = -1;
  expect_refused(
      [&](cellsweep_failure* why) {
        return cellsweep_find_within(world.get(), &region, 1, nullptr, answers.get(), why);
      },
      CELLSWEEP_BAD_INPUT, "-1");
  cellsweep_bodies(answers.get(), 0, &count);
  EXPECT_EQ(count, 3U);
}

TEST(CRefusals, HaveNames) {
  EXPECT_STREQ(cellsweep_status_name(CELLSWEEP_OK), "ok");
  EXPECT_STREQ(cellsweep_status_name(CELLSWEEP_BAD_INPUT), "bad_input");
  EXPECT_STREQ(cellsweep_status_name(CELLSWEEP_CALLBACK_FAILED), "callback_failed");
  EXPECT_STREQ(cellsweep_status_name(11), "unknown");
  EXPECT_STREQ(cellsweep_status_name(-1), "unknown");
}

}  // namespace
}  // namespace cellsweep::c
