/// @file
/// Broadphases made of engine `stream`: which options are refused, and who runs the tasks.
#include "cellsweep/engine/piece_finder.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <memory>
#include <utility>

#include "base/threads/thread_pool.h"
#include "engines/oracle/brute_force.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Runs tasks one after the other and remembers the most that there were at a time.
class CountingExecutor final : public Executor {
 public:
  explicit CountingExecutor(unsigned concurrency) : concurrency_(concurrency) {}

  unsigned concurrency() const override { return concurrency_; }
  void run(unsigned count, Task task, void* context) override {
    most = std::max(most, count);
    for (unsigned i = 0; i < count; ++i) task(context, i);
  }

  unsigned most = 0;

 private:
  unsigned concurrency_;
};

/// Finds no pair and counts, or fails when it is told to.
class CountingFinder final : public PieceFinder {
 public:
  explicit CountingFinder(bool fails) : fails_(fails) {}

  void begin_update() override {}
  void find(std::span<const CellBoxes> cells, KeyBuffer&) override {
    if (fails_) throw PieceFailure{Status::spe_failed("The finder is told to fail.")};
    for (const CellBoxes& cell : cells) boxes_ += cell.count;
  }
  void add_counters(std::vector<Counter>& counters) const override {
    counters.push_back({"boxes found", boxes_});
  }

 private:
  bool fails_;
  std::uint64_t boxes_ = 0;
};

Broadphase updated(const StreamOptions& options, const std::vector<Aabb>& boxes) {
  Broadphase broadphase = engine_with(boxes, options);
  EXPECT_TRUE(broadphase.update().ok());
  return broadphase;
}

TEST(MakeStream, RefusesMoreThreadsThanAnyMachineHas) {
  const Status status = make_broadphase(StreamOptions{.threads = 1025}).status();
  EXPECT_EQ(status.code, StatusCode::bad_option);
  EXPECT_EQ(status.setting, "threads");
  EXPECT_EQ(status.number, 1025U);
  EXPECT_EQ(status.limit, 1024U);
  EXPECT_THAT(status.message, AllOf(HasSubstr("1025"), HasSubstr("1024")));
  EXPECT_TRUE(make_broadphase(StreamOptions{.threads = 1024}).ok()) << "none is started before it is needed";
}

TEST(MakeStream, RefusesAnInstructionSetThatThereIsNot) {
  const Status status = make_broadphase(StreamOptions{.isa = static_cast<VectorIsa>(77)}).status();
  EXPECT_EQ(status.code, StatusCode::bad_option);
  EXPECT_EQ(status.setting, "isa");
  EXPECT_EQ(status.number, 77U);
}

TEST(MakeStream, RefusesAMarginThatIsNoLength) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const float margin :
       {-1.0F, -1e-30F, 1.1e30F, kInfinity, -kInfinity, std::numeric_limits<float>::quiet_NaN()}) {
    const Status status = make_broadphase(StreamOptions{.margin = margin}).status();
    EXPECT_EQ(status.code, StatusCode::bad_option) << margin;
    EXPECT_EQ(status.setting, "margin");
    EXPECT_THAT(status.message, HasSubstr("1e+30"));
  }
  EXPECT_TRUE(make_broadphase(StreamOptions{.margin = 1e30F}).ok());
}

TEST(MakeStream, RefusesATraceFileThatCannotBeWritten) {
  EXPECT_EQ(make_broadphase(StreamOptions{.trace = "/no/such/folder/trace.json"}).status().setting, "trace");
}

TEST(MakeStream, RunsTasksOnTheExecutorThatItIsGiven) {
  const std::vector<Aabb> boxes = uniform_boxes(2500, 1);
  const std::vector<Pair> truth = brute_force_pairs(boxes);
  struct Sharing {
    unsigned threads;
    unsigned concurrency;
    unsigned expected;
  };
  // As many as were asked for, and never more than it takes.
  for (const auto& [threads, concurrency, expected] :
       {Sharing{3, 3, 3}, {2, 4, 2}, {8, 4, 4}, {1, 4, 0}, {4, 1, 0}, {4, 0, 0}}) {
    const auto executor = std::make_shared<CountingExecutor>(concurrency);
    const Broadphase broadphase = updated({.threads = threads, .executor = executor}, boxes);
    EXPECT_EQ(executor->most, expected) << threads << " threads of " << concurrency;
    EXPECT_TRUE(std::ranges::equal(broadphase.pairs(), truth));
  }
}

TEST(MakeStream, SharesItsExecutorWithTheBroadphase) {
  auto executor = std::make_shared<CountingExecutor>(3);
  const std::weak_ptr<Executor> watched = executor;
  {
    const Broadphase broadphase =
        updated({.threads = 3, .executor = std::move(executor)}, uniform_boxes(500, 1));
    EXPECT_FALSE(watched.expired());
  }
  EXPECT_TRUE(watched.expired());
}

TEST(MakeStream, MayHaveAThreadPoolForExecutor) {
  const std::vector<Aabb> boxes = uniform_boxes(2000 / kScale, 2);
  const auto pool = std::make_shared<ThreadPool>(3);
  const Broadphase one = updated({.threads = 3, .executor = pool}, boxes);
  const Broadphase other = updated({.threads = 2, .executor = pool}, boxes);
  EXPECT_TRUE(is_exact(one, boxes));
  EXPECT_TRUE(is_exact(other, boxes));
}

TEST(MakeStreamWithAFinder, IsCalledByItsNameAndCountsWhatTheFinderCounts) {
  const auto make_finder = []() -> Result<std::unique_ptr<PieceFinder>> {
    return std::unique_ptr<PieceFinder>(std::make_unique<CountingFinder>(false));
  };
  auto made = make_stream_broadphase({}, "counting", make_finder, "row");
  ASSERT_TRUE(made.ok());
  EXPECT_EQ(made->name(), "counting");
  insert_all(*made, uniform_boxes(500, 1));
  ASSERT_TRUE(made->update().ok());
  EXPECT_TRUE(made->pairs().empty());
  EXPECT_GE(counter(*made, "boxes found"), 500U);
}

TEST(MakeStreamWithAFinder, IsRefusedWhenThereIsNone) {
  const auto make_none = []() -> Result<std::unique_ptr<PieceFinder>> {
    return Status::bad_option("spus", "None.");
  };
  EXPECT_EQ(make_stream_broadphase({}, "none", make_none, "row").status().setting, "spus");
}

TEST(MakeStreamWithAFinder, GetsANewOneAfterAFailure) {
  int made_so_far = 0;
  const auto make_finder = [&]() -> Result<std::unique_ptr<PieceFinder>> {
    const bool fails = ++made_so_far < 3;
    return std::unique_ptr<PieceFinder>(std::make_unique<CountingFinder>(fails));
  };
  auto made = make_stream_broadphase({}, "failing", make_finder, "row");
  ASSERT_TRUE(made.ok());
  insert_all(*made, uniform_boxes(500, 1));
  EXPECT_EQ(made->update().status().code, StatusCode::spe_failed);
  EXPECT_EQ(made->update().status().code, StatusCode::spe_failed);
  EXPECT_TRUE(made->update().ok());
  EXPECT_EQ(made_so_far, 3);
}

}  // namespace
}  // namespace cellsweep::stream
