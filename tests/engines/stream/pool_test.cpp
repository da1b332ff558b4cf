#include "engines/stream/pool.h"

#include <gmock/gmock.h>

#include <array>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace cellsweep::stream {
namespace {

TEST(Pool, CallsEveryWorkerOnceAJob) {
  for (const unsigned workers : {1U, 2U, 3U, 16U}) {
    Pool pool(workers);
    std::vector<int> calls(workers, 0);
    for (int job = 0; job < 200; ++job) pool.run([&](unsigned worker) { ++calls[worker]; });
    EXPECT_THAT(calls, testing::Each(200)) << workers << " workers";
  }
}

TEST(Pool, LeavesOutWorkersThatAreNotInUse) {
  Pool pool(4);
  std::array<int, 4> calls{};
  for (const unsigned used : {2U, 4U, 1U, 9U, 0U}) {
    pool.use(used);
    pool.run([&](unsigned worker) { ++calls[worker]; });
  }
  EXPECT_THAT(calls, testing::ElementsAre(5, 3, 2, 2));
}

TEST(Pool, VisitsEveryIndexOnce) {
  for (const unsigned workers : {1U, 3U}) {
    Pool pool(workers);
    for (const std::size_t count : {0, 1, 7, 1000}) {
      std::vector<int> visits(count, 0);
      pool.for_each(count, 8, [&](unsigned, std::size_t index) { ++visits[index]; });
      EXPECT_EQ(std::accumulate(visits.begin(), visits.end(), std::size_t{0}), count);
      EXPECT_THAT(visits, testing::Each(1));
    }
  }
}

TEST(Pool, HandsOnWhatAJobThrewAndGoesOn) {
  Pool pool(3);
  for (const unsigned thrower : {0U, 2U}) {
    const auto job = [&](unsigned worker) {
      if (worker == thrower) throw std::runtime_error("thrown by a job");
    };
    EXPECT_THROW(pool.run(job), std::runtime_error);
    int calls = 0;
    pool.run([&](unsigned worker) {
      if (worker == 0) ++calls;
    });
    EXPECT_EQ(calls, 1);
  }
}

TEST(Share, CutsAListWithoutGapOrOverlap) {
  for (const std::size_t count : {0, 1, 5, 100}) {
    std::size_t next = 0;
    for (unsigned worker = 0; worker < 7; ++worker) {
      const Share share = Share::of(count, worker, 7);
      EXPECT_EQ(share.first, next);
      next = share.last;
    }
    EXPECT_EQ(next, count);
  }
}

}  // namespace
}  // namespace cellsweep::stream
