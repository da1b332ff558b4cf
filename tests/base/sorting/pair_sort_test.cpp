/// @file
/// Pair keys of every distribution, in any number of parts, by any number of workers, against std::sort.
#include "base/sorting/pair_sort.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "base/memory/starved.h"
#include "base/threads/thread_pool.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using contract::Random;

/// A family of keys: `first` makes the numbers above, `second` those below.
struct Family {
  const char* name;
  std::uint32_t (*first)(Random& random, std::size_t count);
};

std::uint32_t any(Random& random) {
  return static_cast<std::uint32_t>(random.bits());
}

const Family kFamilies[] = {
    {"dense", [](Random& random,
                 std::size_t count) { return static_cast<std::uint32_t>(random.below(count / 3 + 1)); }},
    {"dense far from zero",
     [](Random& random, std::size_t count) {
       return 0xffffffffU - static_cast<std::uint32_t>(random.below(count / 3 + 1));
     }},
    {"scattered", [](Random& random, std::size_t) { return any(random); }},
    {"one first number", [](Random&, std::size_t) { return 77U; }},
    {"one first number in most",
     [](Random& random, std::size_t) { return random.one_in(10) ? any(random) : 5U; }},
    {"few first numbers far apart",
     [](Random& random, std::size_t) { return static_cast<std::uint32_t>(random.below(40)) * 107'374'182U; }},
    {"two clumps",
     [](Random& random, std::size_t) {
       return static_cast<std::uint32_t>(random.below(900)) + (random.one_in(2) ? 0xf0000000U : 0U);
     }},
    {"clumps in clumps", [](Random& random, std::size_t) { return any(random) >> random.below(32); }},
    {"the first and the last number",
     [](Random& random, std::size_t) { return random.one_in(2) ? 0U : 0xffffffffU; }},
};

std::vector<std::uint64_t> random_keys(Random& random, const Family& family, std::size_t count) {
  std::set<std::uint64_t> keys;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint64_t first = family.first(random, count);
    keys.insert(first << 32 | (random.one_in(2) ? any(random) : static_cast<std::uint32_t>(i)));
  }
  std::vector<std::uint64_t> mixed(keys.begin(), keys.end());
  random.shuffle(mixed);
  return mixed;
}

/// The keys cut into parts, some of them empty.
std::vector<std::span<const std::uint64_t>> cut(Random& random, std::span<const std::uint64_t> keys,
                                                std::size_t parts) {
  std::vector<std::span<const std::uint64_t>> all;
  for (std::size_t part = 1; part < parts; ++part) {
    const std::size_t length = random.one_in(3) ? 0 : random.below(keys.size() + 1);
    all.push_back(keys.first(length));
    keys = keys.subspan(length);
  }
  all.push_back(keys);
  return all;
}

template <class AnyPair>
class PairSort : public testing::Test {
 protected:
  testing::AssertionResult is_sorted_by(Crew& crew, const std::vector<std::uint64_t>& keys,
                                        std::size_t parts) {
    const std::vector<std::uint64_t> given = keys;
    sort_pairs(crew, cut(random_, keys, parts), scratch_, sorted_);
    if (keys != given) return testing::AssertionFailure() << "what was given has changed";
    return is_right(keys);
  }

  testing::AssertionResult is_right(std::vector<std::uint64_t> keys) const {
    std::sort(keys.begin(), keys.end());
    const bool right =
        std::ranges::equal(sorted_.view(), keys, {}, [](const AnyPair& pair) { return pair_key(pair); });
    return right ? testing::AssertionSuccess() : testing::AssertionFailure();
  }

  Random random_{1};
  Array<std::uint64_t> scratch_;
  Array<AnyPair> sorted_;
};

using AllPairs = testing::Types<Pair, SlotPair>;
TYPED_TEST_SUITE(PairSort, AllPairs);

// Numbers of keys around those at which another way is taken.
constexpr std::size_t kCounts[] = {0, 1, 2, 24, 25, 300, 511, 512, 2047, 2048, 2049, 16'384, 16'385, 40'000};

TYPED_TEST(PairSort, IsStdSortOnEveryFamilyOfKeysWithAnyWorkersAndParts) {
  Crew alone(nullptr, 1, Crew::Choice::given);
  Crew three(std::make_shared<ThreadPool>(3), 3, Crew::Choice::given);
  for (const Family& family : kFamilies) {
    for (const std::size_t count : kCounts) {
      const std::vector<std::uint64_t> keys = random_keys(this->random_, family, count);
      for (Crew* crew : {&alone, &three}) {
        for (const std::size_t parts : {1, 2, 5}) {
          ASSERT_TRUE(this->is_sorted_by(*crew, keys, parts))
              << keys.size() << " keys, " << family.name << ", " << crew->active() << " workers, " << parts
              << " parts";
        }
      }
    }
  }
}

TYPED_TEST(PairSort, OfNoPartsIsEmpty) {
  Crew crew(nullptr, 1, Crew::Choice::given);
  ASSERT_TRUE(this->is_sorted_by(crew, random_keys(this->random_, kFamilies[0], 100), 1));
  sort_pairs(crew, {}, this->scratch_, this->sorted_);
  EXPECT_EQ(this->sorted_.size(), 0U);
}

TYPED_TEST(PairSort, SucceedsAfterMemoryFailed) {
  Crew crew(std::make_shared<ThreadPool>(3), 3, Crew::Choice::given);
  const std::vector<std::uint64_t> keys = random_keys(this->random_, kFamilies[2], 20'000);
  const std::span<const std::uint64_t> all = keys;
  const auto sort = [&] { sort_pairs(crew, {&all, 1}, this->scratch_, this->sorted_); };
  std::uint64_t n = 1;
  for (; fails_at(n, sort); ++n) {
    sort();
    ASSERT_TRUE(this->is_right(keys));
    this->scratch_ = {};
    this->sorted_ = {};
  }
  EXPECT_EQ(n, 3U) << "one array for the pairs and one to work in";
}

}  // namespace
}  // namespace cellsweep
