/// @file
/// Callbacks of a C program's: job systems that have no memory, exceptions that come from C++.
#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <vector>

#include "bindings/c/c_world.h"

namespace cellsweep::c {
namespace {

struct Jobs {
  int runs = 0;
  int failing_run = 0;  // the n-th one
  int releases = 0;
};

bool run_in_turn(void* context, unsigned count, cellsweep_task task, void* task_context) {
  auto& jobs = *static_cast<Jobs*>(context);
  if (++jobs.runs == jobs.failing_run) return false;
  for (unsigned i = 0; i < count; ++i) task(task_context, i);
  return true;
}

void release(void* context) {
  ++static_cast<Jobs*>(context)->releases;
}

cellsweep_executor executor_of(Jobs& jobs) {
  return {4, run_in_turn, &jobs, release};
}

cellsweep_stream_options options_with(const cellsweep_executor& executor) {
  cellsweep_stream_options options = {};
  options.size = sizeof options;
  options.threads = 4;
  options.executor = &executor;
  return options;
}

/// Enough of them for every task.
std::vector<cellsweep_aabb> cubes_in_a_row(std::size_t count = 3000) {
  std::vector<cellsweep_aabb> cubes(count, kCube);
  for (std::size_t i = 0; i < cubes.size(); ++i) {
    cubes[i].min[0] += static_cast<float>(i);
    cubes[i].max[0] += static_cast<float>(i);
  }
  return cubes;
}

TEST(CExecutor, RunsUpdatesAndIsReleasedWithItsWorld) {
  Jobs jobs;
  const cellsweep_executor executor = executor_of(jobs);
  const cellsweep_stream_options options = options_with(executor);
  World world = make_world(&options);
  const auto cubes = cubes_in_a_row();
  std::vector<uint32_t> ids(cubes.size());
  const cellsweep_boxes boxes = cellsweep_boxes_of(cubes.data(), cubes.size());
  ASSERT_EQ(cellsweep_add(world.get(), boxes, ids.data(), nullptr), CELLSWEEP_OK);
  ASSERT_EQ(cellsweep_update(world.get(), nullptr, nullptr), CELLSWEEP_OK);
  EXPECT_EQ(pairs_of(world).size(), cubes.size() - 1);
  EXPECT_GT(jobs.runs, 0);
  EXPECT_EQ(jobs.releases, 0);
  world.reset();
  EXPECT_EQ(jobs.releases, 1);
}

TEST(CExecutor, WithoutMemoryLeavesTheWorldAndIsAskedAgain) {
  Jobs jobs;
  const cellsweep_executor executor = executor_of(jobs);
  const cellsweep_stream_options options = options_with(executor);
  const World world = make_world(&options);
  const auto cubes = cubes_in_a_row();
  std::vector<uint32_t> ids(cubes.size());
  const cellsweep_boxes boxes = cellsweep_boxes_of(cubes.data(), cubes.size());
  ASSERT_EQ(cellsweep_add(world.get(), boxes, ids.data(), nullptr), CELLSWEEP_OK);
  jobs.failing_run = jobs.runs + 1;
  cellsweep_failure why;
  ASSERT_EQ(cellsweep_update(world.get(), nullptr, &why), CELLSWEEP_NO_MEMORY);
  EXPECT_STREQ(why.message, "There is no memory for this call; nothing has changed.");
  EXPECT_TRUE(pairs_of(world).empty());
  ASSERT_EQ(cellsweep_update(world.get(), nullptr, &why), CELLSWEEP_OK);
  EXPECT_EQ(pairs_of(world).size(), cubes.size() - 1);
}

TEST(CExecutor, IsNotReleasedByACallThatFailsOrDoesNotKeepIt) {
  Jobs jobs;
  const cellsweep_executor executor = executor_of(jobs);
  cellsweep_stream_options options = options_with(executor);
  options.margin = -1;
  cellsweep_broadphase* made = nullptr;
  EXPECT_EQ(cellsweep_create(&options, &made, nullptr), CELLSWEEP_BAD_OPTION);
  cellsweep_find_options find = {};
  find.size = sizeof find;
  find.threads = 4;
  find.executor = &executor;
  const auto cubes = cubes_in_a_row(100'000);  // fewer on a line are swept, by the caller alone
  uint64_t count = 0;
  EXPECT_EQ(cellsweep_count_pairs(cellsweep_boxes_of(cubes.data(), cubes.size()), &find, &count, nullptr),
            CELLSWEEP_OK);
  EXPECT_EQ(count, cubes.size() - 1);
  EXPECT_GT(jobs.runs, 0);
  EXPECT_EQ(jobs.releases, 0);
}

bool throw_at_pair(void*, cellsweep_pair) {
  throw std::runtime_error("of the caller's");
}
bool throw_at_body(void*, uint32_t) {
  throw std::runtime_error("of the caller's");
}
double throw_at_touch(void*, cellsweep_touch, double) {
  throw 5;
}
bool find_no_memory(void*, uint32_t) {
  throw std::bad_alloc();
}

TEST(CCallbacks, WhoseExceptionsEndTheCallAndGoNoFurther) {
  const World world = make_cubes(5);
  const std::vector<cellsweep_aabb> cubes(5, kCube);
  const cellsweep_boxes boxes = cellsweep_boxes_of(cubes.data(), cubes.size());
  const cellsweep_region region = cellsweep_box_region(kCube);
  const double direction[3] = {1, 0, 0};
  const cellsweep_path path = cellsweep_moving_box(kCube, direction);
  const Answers answers = make_answers();
  cellsweep_failure why;
  EXPECT_EQ(cellsweep_visit_pairs(boxes, nullptr, throw_at_pair, nullptr, &why), CELLSWEEP_CALLBACK_FAILED);
  EXPECT_EQ(why.status, CELLSWEEP_CALLBACK_FAILED);
  EXPECT_EQ(cellsweep_visit_pairs_between(boxes, boxes, nullptr, throw_at_pair, nullptr, nullptr),
            CELLSWEEP_CALLBACK_FAILED);
  EXPECT_EQ(cellsweep_visit_overlaps(world.get(), &region, nullptr, throw_at_body, nullptr, nullptr),
            CELLSWEEP_CALLBACK_FAILED);
  EXPECT_EQ(cellsweep_visit_touches(world.get(), &path, nullptr, throw_at_touch, nullptr, nullptr),
            CELLSWEEP_CALLBACK_FAILED);
  ASSERT_EQ(cellsweep_find_overlaps(world.get(), &region, 1, nullptr, answers.get(), nullptr), CELLSWEEP_OK);
  const cellsweep_query_filter scarce = {nullptr, find_no_memory, nullptr};
  EXPECT_EQ(cellsweep_find_overlaps(world.get(), &region, 1, &scarce, answers.get(), &why),
            CELLSWEEP_NO_MEMORY);
  std::size_t count = 7;
  EXPECT_EQ(cellsweep_bodies(answers.get(), 0, &count), nullptr) << "there are none after an exception";
  EXPECT_EQ(count, 0U);
  EXPECT_EQ(cellsweep_find_overlaps(world.get(), &region, 1, nullptr, answers.get(), nullptr), CELLSWEEP_OK);
  cellsweep_bodies(answers.get(), 0, &count);
  EXPECT_EQ(count, 5U);
}

}  // namespace
}  // namespace cellsweep::c
