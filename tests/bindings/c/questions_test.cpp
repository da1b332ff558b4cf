/// @file
/// Questions through the face for C: the answers are those of C++.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "bindings/c/c_world.h"
#include "cellsweep/query.h"
#include "contract/box_kinds.h"
#include "contract/random.h"

namespace cellsweep::c {
namespace {

using contract::Random;

constexpr double kAnywhere = std::numeric_limits<double>::infinity();

bool is_multiple(void* context, uint32_t id) {
  return id % *static_cast<uint32_t*>(context) == 0;
}

bool note_body(void* context, uint32_t id) {
  static_cast<std::vector<BodyId>*>(context)->push_back(id);
  return true;
}

double note_touch(void* context, cellsweep_touch touch, double end) {
  static_cast<std::vector<Touch>*>(context)->push_back({touch.body, touch.time});
  return end;
}

/// One kind's world, questions to it, and what they are filtered by.
class CQuestions : public testing::TestWithParam<std::size_t> {
 protected:
  static constexpr std::size_t kBodies = 300;

  CQuestions() {
    const contract::BoxKind& kind = contract::box_kinds()[GetParam() / 4];
    Random random(GetParam());
    boxes_ = contract::make_boxes(kind, random, kBodies);
    std::vector<BodyId> ids(kBodies);
    for (std::size_t i = 0; i < kBodies; ++i) ids[i] = static_cast<BodyId>(3 * i + 1);
    EXPECT_TRUE(handle_.insert(ids, boxes_).ok() && handle_.update().ok());
    EXPECT_EQ(cellsweep_insert(world_.get(), ids_in(ids), boxes_in(boxes_), cellsweep_no_filters(), nullptr),
              CELLSWEEP_OK);
    EXPECT_EQ(cellsweep_update(world_.get(), nullptr, nullptr), CELLSWEEP_OK);
    const std::size_t questions = GetParam() % 2 == 0 ? 20 : 1;
    for (std::size_t i = 0; i < questions; ++i) ask_near(random.pick(boxes_), random);
    if (GetParam() % 4 < 2) return;
    filter_ = {&as_, is_multiple, &two_};
    expected_filter_.predicate = [](BodyId id) { return id % 2 == 0; };
    expected_filter_.as = BodyFilter{.category = 1, .mask = 1};
  }

  void ask_near(const Aabb& box, Random& random) {
    const double reach = random.unit();
    regions_.push_back({{}, reach});
    std::copy_n(box.min.data(), 3, regions_.back().box.min);
    std::copy_n(box.max.data(), 3, regions_.back().box.max);
    expected_regions_.emplace_back(box, reach);
    const std::array<double, 3> direction = {random.unit() - 0.5, 0, random.unit() + 0.1};
    cellsweep_path path = cellsweep_moving_box(regions_.back().box, direction.data());
    path.end = 3;
    paths_.push_back(path);
    expected_paths_.emplace_back(MovingBox{box, direction, 3});
    asked_boxes_.push_back(regions_.back().box);
    expected_boxes_.push_back(box);
  }

  template <class Answer, class Told, class Tell>
  void expect_told(const BatchAnswers<Answer>& expected, const Tell& tell,
                   bool (*same)(const Told&, const Answer&)) {
    for (std::size_t i = 0; i < expected.size(); ++i) {
      std::size_t count = 0;
      const Told* told = tell(answers_.get(), i, &count);
      ASSERT_EQ(count, expected[i].size());
      for (std::size_t k = 0; k < count; ++k) EXPECT_TRUE(same(told[k], expected[i][k]));
    }
    std::size_t count = 1;
    EXPECT_EQ(tell(answers_.get(), expected.size(), &count), nullptr);
    EXPECT_EQ(count, 0U);
  }

  static bool same_body(const uint32_t& told, const BodyId& expected) { return told == expected; }
  static bool same_touch(const cellsweep_touch& told, const Touch& expected) {
    return told.body == expected.body && told.time == expected.time;
  }
  static bool same_neighbor(const cellsweep_neighbor& told, const Neighbor& expected) {
    return told.body == expected.body && told.distance == expected.distance;
  }

  std::vector<Aabb> boxes_;
  Broadphase handle_;
  Queries queries_{handle_};
  World world_ = make_world();
  Answers answers_ = make_answers();
  uint32_t two_ = 2;
  cellsweep_filter as_ = {1, 1, false};
  cellsweep_query_filter filter_ = {};
  QueryFilter expected_filter_;
  std::vector<cellsweep_region> regions_;
  std::vector<Region> expected_regions_;
  std::vector<cellsweep_path> paths_;
  std::vector<Path> expected_paths_;
  std::vector<cellsweep_aabb> asked_boxes_;
  std::vector<Aabb> expected_boxes_;
};

TEST_P(CQuestions, AboutRegions) {
  BatchAnswers<BodyId> expected;
  ASSERT_TRUE(queries_.find_overlaps(expected_regions_, expected, expected_filter_).ok());
  ASSERT_EQ(cellsweep_find_overlaps(world_.get(), regions_.data(), regions_.size(), &filter_, answers_.get(),
                                    nullptr),
            CELLSWEEP_OK);
  expect_told<BodyId, uint32_t>(expected, cellsweep_bodies, same_body);
  const auto any = std::make_unique<bool[]>(regions_.size());
  ASSERT_EQ(
      cellsweep_any_overlaps(world_.get(), regions_.data(), regions_.size(), &filter_, any.get(), nullptr),
      CELLSWEEP_OK);
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    EXPECT_EQ(any[i], !expected[i].empty());
    std::vector<BodyId> visited;
    ASSERT_EQ(cellsweep_visit_overlaps(world_.get(), &regions_[i], &filter_, note_body, &visited, nullptr),
              CELLSWEEP_OK);
    std::sort(visited.begin(), visited.end());
    EXPECT_EQ(visited, std::vector(expected[i].begin(), expected[i].end()));
  }
}

TEST_P(CQuestions, AboutPaths) {
  ASSERT_EQ(cellsweep_prepare_queries(world_.get(), nullptr), CELLSWEEP_OK);
  BatchAnswers<Touch> expected;
  ASSERT_TRUE(queries_.find_touches(expected_paths_, expected, expected_filter_).ok());
  ASSERT_EQ(
      cellsweep_find_touches(world_.get(), paths_.data(), paths_.size(), &filter_, answers_.get(), nullptr),
      CELLSWEEP_OK);
  expect_told<Touch, cellsweep_touch>(expected, cellsweep_touches, same_touch);
  const auto any = std::make_unique<bool[]>(paths_.size());
  std::vector<cellsweep_first_touch> first(paths_.size());
  ASSERT_EQ(cellsweep_any_touches(world_.get(), paths_.data(), paths_.size(), &filter_, any.get(), nullptr),
            CELLSWEEP_OK);
  ASSERT_EQ(
      cellsweep_first_touches(world_.get(), paths_.data(), paths_.size(), &filter_, first.data(), nullptr),
      CELLSWEEP_OK);
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    EXPECT_EQ(any[i], !expected[i].empty());
    EXPECT_EQ(first[i].is_there, !expected[i].empty());
    EXPECT_TRUE(expected[i].empty() || same_touch(first[i].touch, expected[i][0]));
    std::vector<Touch> visited;
    ASSERT_EQ(cellsweep_visit_touches(world_.get(), &paths_[i], &filter_, note_touch, &visited, nullptr),
              CELLSWEEP_OK);
    std::sort(visited.begin(), visited.end(), [](const Touch& a, const Touch& b) {
      return a.time < b.time || (a.time == b.time && a.body < b.body);
    });
    EXPECT_EQ(visited, std::vector(expected[i].begin(), expected[i].end()));
  }
}

TEST_P(CQuestions, AboutWhatIsNear) {
  BatchAnswers<Neighbor> expected;
  ASSERT_TRUE(queries_.find_nearest(expected_boxes_, 5, expected, kAnywhere, expected_filter_).ok());
  ASSERT_EQ(cellsweep_find_nearest(world_.get(), asked_boxes_.data(), asked_boxes_.size(), 5, kAnywhere,
                                   &filter_, answers_.get(), nullptr),
            CELLSWEEP_OK);
  expect_told<Neighbor, cellsweep_neighbor>(expected, cellsweep_neighbors, same_neighbor);
  ASSERT_TRUE(queries_.find_within(expected_regions_, expected, expected_filter_).ok());
  ASSERT_EQ(cellsweep_find_within(world_.get(), regions_.data(), regions_.size(), &filter_, answers_.get(),
                                  nullptr),
            CELLSWEEP_OK);
  expect_told<Neighbor, cellsweep_neighbor>(expected, cellsweep_neighbors, same_neighbor);
  EXPECT_EQ(cellsweep_bodies(answers_.get(), 0, nullptr), nullptr) << "of another kind";
  EXPECT_EQ(cellsweep_touches(answers_.get(), 0, nullptr), nullptr);
}

TEST_P(CQuestions, AboutPairsOfSomeBodies) {
  const std::vector<BodyId> some = {1, 4, 31, 301};
  std::vector<Pair> expected;
  ASSERT_TRUE(queries_.find_pairs_of(some, expected).ok());
  const PairList list = make_list();
  ASSERT_EQ(cellsweep_find_pairs_of(world_.get(), ids_in(some), list.get(), nullptr), CELLSWEEP_OK);
  EXPECT_EQ(pairs_in(list), expected);
}

INSTANTIATE_TEST_SUITE_P(OnKindsOfBoxes, CQuestions,
                         testing::Range(std::size_t{0}, 4 * contract::box_kinds().size()));

TEST(CHelpers, MakeWhatTheySay) {
  const float from[3] = {1, 2, 3};
  const float to[3] = {4, 4, 4};
  const double direction[3] = {1, 0, -1};
  const cellsweep_path segment = cellsweep_segment(from, to);
  EXPECT_EQ(segment.direction[0], 3);
  EXPECT_EQ(segment.direction[2], 1);
  EXPECT_EQ(segment.end, 1);
  const cellsweep_path ray = cellsweep_ray(from, direction);
  EXPECT_EQ(ray.box.max[1], 2);
  EXPECT_EQ(ray.direction[2], -1);
  EXPECT_EQ(ray.end, kAnywhere);
  EXPECT_EQ(cellsweep_sphere(1, 2, 3, 4).distance, 4);
  EXPECT_EQ(cellsweep_box_region(kCube).distance, 0);
}

}  // namespace
}  // namespace cellsweep::c
