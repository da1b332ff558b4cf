/// @file
/// Keys of pairs in buckets, put there a part at a time by any number of workers.
#include "base/sorting/key_buckets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/threads/numbers_of_workers.h"
#include "base/threads/thread_pool.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using contract::Random;
using Keys = std::vector<std::uint64_t>;

class KeyBucketsTest : public testing::TestWithParam<unsigned> {
 protected:
  Keys random_keys(std::size_t count, std::uint32_t first, std::size_t bodies) {
    Keys keys;
    for (std::size_t i = 0; i < count; ++i)
      keys.push_back(std::uint64_t{first + static_cast<std::uint32_t>(random_.below(bodies))} << 32 | i);
    return keys;
  }

  /// What is in a bucket is above all that is in those before it.
  static void expect_in_order(const KeyBuckets& buckets, Keys given, const Keys& to) {
    const std::span<const std::size_t> begins = buckets.begins();
    EXPECT_EQ(begins.front(), 0U);
    EXPECT_EQ(begins.back(), given.size());
    std::uint64_t before = 0;
    for (std::size_t i = 0; i + 1 < begins.size(); ++i) {
      const auto bucket = std::span(to).subspan(begins[i], begins[i + 1] - begins[i]);
      if (bucket.empty()) continue;
      EXPECT_GE(*std::ranges::min_element(bucket), before);
      before = *std::ranges::max_element(bucket);
    }
    Keys sorted = to;
    std::ranges::sort(sorted);
    std::ranges::sort(given);
    EXPECT_EQ(sorted, given);
  }

  Random random_{1};
  Crew crew_{std::make_shared<ThreadPool>(GetParam()), GetParam(), Crew::Choice::given};
};

TEST_P(KeyBucketsTest, AreFullWhenAllPartsAreDone) {
  for (const std::size_t bodies : {1U, 300U, 5'000U, 3'000'000U, 0xffff'0000U}) {
    const Keys keys = random_keys(40'000, 7, bodies);
    const std::span<const std::uint64_t> all = keys;
    const std::vector<std::span<const std::uint64_t>> given = {all.first(9), {}, all.subspan(9)};
    for (const std::size_t parts : {std::size_t{GetParam()}, std::size_t{16}}) {
      KeyBuckets buckets(crew_, given, parts);
      Keys to(keys.size());
      for (std::size_t done = 1; done <= parts; done += 3) {
        EXPECT_FALSE(buckets.are_full());
        buckets.distribute(crew_, done, to.data());
        buckets.distribute(crew_, done - 1, to.data());  // nothing is left to be done for that
      }
      buckets.distribute(crew_, parts, to.data());
      EXPECT_TRUE(buckets.are_full());
      expect_in_order(buckets, keys, to);
    }
  }
}

TEST_P(KeyBucketsTest, AreTheSameForAnyWorkersWhateverIsDoneAtATime) {
  const Keys keys = random_keys(20'000, 0, 100'000);
  const std::span<const std::uint64_t> all = keys;
  Crew alone(nullptr, 1, Crew::Choice::given);
  KeyBuckets at_once(alone, {&all, 1}, 16), in_parts(crew_, {&all, 1}, 16);
  Keys one(keys.size()), other(keys.size());
  at_once.distribute(alone, 16, one.data());
  for (std::size_t done = 1; done <= 16; ++done) in_parts.distribute(crew_, done, other.data());
  EXPECT_EQ(one, other);
}

TEST_P(KeyBucketsTest, MayBeOfFewerKeysThanParts) {
  for (std::size_t count = 1; count < 4; ++count) {
    const Keys keys = random_keys(count, 0xffff'fff0U, 15);
    const std::span<const std::uint64_t> all = keys;
    KeyBuckets buckets(crew_, {&all, 1}, 16);
    Keys to(count);
    buckets.distribute(crew_, 16, to.data());
    expect_in_order(buckets, keys, to);
  }
}

INSTANTIATE_TEST_SUITE_P(Workers, KeyBucketsTest, numbers_of_workers());

}  // namespace
}  // namespace cellsweep
