/// @file
/// Work that is put off is done once, by whoever needs it first.
#include "base/threads/deferred.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

namespace cellsweep {
namespace {

TEST(Deferred, IsNothingToDoAtFirst) {
  const Deferred deferred;
  EXPECT_FALSE(deferred.waits());
  deferred.finish([] { FAIL(); });
}

TEST(Deferred, IsDoneOnceByAnyNumberOfThreads) {
  for (int round = 0; round < 200; ++round) {
    Deferred deferred;
    deferred.put_off();
    int done = 0;
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i) {
      threads.emplace_back([&] {
        deferred.finish([&] { ++done; });
        ASSERT_EQ(done, 1) << "seen by all";
      });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_FALSE(deferred.waits());
  }
}

TEST(Deferred, IsStillLeftToDoAfterAFailure) {
  Deferred deferred;
  deferred.put_off();
  EXPECT_THROW(deferred.finish([] { throw std::runtime_error("no"); }), std::runtime_error);
  EXPECT_TRUE(deferred.waits());
  bool done = false;
  deferred.finish([&] { done = true; });
  EXPECT_TRUE(done);
}

TEST(Deferred, NeedNotBeDoneAnyMore) {
  Deferred deferred;
  deferred.put_off();
  deferred.put_off(false);
  deferred.finish([] { FAIL(); });
}

TEST(Deferred, MovesWithWhatItIsAPartOf) {
  Deferred first;
  first.put_off();
  Deferred second = std::move(first);
  EXPECT_TRUE(second.waits());
  Deferred third;
  third = std::move(second);
  EXPECT_TRUE(third.waits());
  third = Deferred();
  EXPECT_FALSE(third.waits());
}

}  // namespace
}  // namespace cellsweep
