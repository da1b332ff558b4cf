/// @file
/// The steps of cell-resident's SPU program, compiled for this machine, against scalar references (F2).
#define SPU_EMU_NO_VECTOR_KEYWORD
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cfloat>
#include <cstdint>
#include <cstring>
#include <map>
#include <vector>

#include "contract/random.h"
#include "engines/cell/resident_wire.h"
#include "engines/cell/spu/resident/lanes.h"
#include "engines/cell/spu/resident/search.h"
#include "engines/cell/spu/resident/sort_network.h"
#include "engines/cell/spu/resident/sorted_axis.h"

namespace cellsweep::cell {
namespace {

using contract::Random;

/// Numbers in as many vectors as they take; the last one is filled up.
template <class V, class T>
std::vector<V> vectors_of(const std::vector<T>& numbers, T padding) {
  std::vector<V> result((numbers.size() + 3) / 4);
  for (std::size_t i = 0; i < 4 * result.size(); ++i) {
    reinterpret_cast<T*>(result.data())[i] = i < numbers.size() ? numbers[i] : padding;
  }
  return result;
}

template <class T, class V>
std::vector<T> numbers_of(const std::vector<V>& vectors, std::size_t count) {
  const T* first = reinterpret_cast<const T*>(vectors.data());
  return std::vector<T>(first, first + count);
}

TEST(ResidentCompaction, EveryMaskAfterEveryMaskKeepsTheRightWords) {
  for (std::uint32_t masks = 0; masks < 1U << 16; ++masks) {
    std::vector<std::uint32_t> words(16);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < 16; ++i) {
      words[i] = 1000 + i;
      if ((masks >> (15 - i) & 1U) != 0) expected.push_back(words[i]);
    }
    auto vectors = vectors_of<vec_uint4>(words, 0U);
    WordWriter writer(vectors.data());
    for (std::size_t i = 0; i < 4; ++i) writer.append(vectors[i], masks >> (12 - 4 * i) & 15U);
    const std::uint32_t count = writer.finish(spu_splats(7U));
    ASSERT_EQ(count, expected.size());
    ASSERT_EQ(numbers_of<std::uint32_t>(vectors, count), expected) << "masks " << masks;
    for (std::size_t i = count; i % 4 != 0; ++i) {
      ASSERT_EQ(reinterpret_cast<std::uint32_t*>(vectors.data())[i], 7U) << "the vector is not filled up";
    }
  }
}

/// A network that sorts every array of zeros and ones sorts everything.
TEST(ResidentSortNetwork, SixteenKeysAreSortedWhateverTheyAre) {
  for (std::uint32_t bits = 0; bits < 1U << 16; ++bits) {
    std::vector<int> numbers(16);
    for (std::uint32_t i = 0; i < 16; ++i) numbers[i] = static_cast<int>(bits >> i & 1U);
    auto keys = vectors_of<vec_int4>(numbers, 0);
    auto values = keys;
    sort_network(keys.data(), values.data(), 4);
    std::sort(numbers.begin(), numbers.end());
    ASSERT_EQ(numbers_of<int>(keys, 16), numbers) << "bits " << bits;
    ASSERT_EQ(numbers_of<int>(values, 16), numbers) << "bits " << bits;
  }
}

TEST(ResidentSortNetwork, ValuesGoWithTheirKeysAtEverySize) {
  Random random(5);
  for (std::uint32_t vectors = 1; vectors <= 256; vectors *= 2) {
    for (const int largest : {0, 3, 1 << 29}) {
      std::vector<int> numbers(4 * vectors);
      std::vector<int> places(4 * vectors);
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        numbers[i] = random.whole(-largest, largest);
        places[i] = static_cast<int>(i);
      }
      auto keys = vectors_of<vec_int4>(numbers, 0);
      auto values = vectors_of<vec_int4>(places, 0);
      sort_network(keys.data(), values.data(), vectors);
      const std::vector<int> sorted = numbers_of<int>(keys, numbers.size());
      std::vector<int> order = numbers_of<int>(values, numbers.size());
      ASSERT_TRUE(std::is_sorted(sorted.begin(), sorted.end()));
      for (std::size_t i = 0; i < order.size(); ++i) ASSERT_EQ(numbers[order[i]], sorted[i]);
      std::sort(order.begin(), order.end());
      ASSERT_EQ(order, places) << "the values are no permutation";
    }
  }
}

/// Sorts by the upper half of a key and removes duplicates, as the program does with places.
std::vector<int> distinct(const std::vector<int>& places) {
  std::vector<int> numbers;
  for (std::size_t i = 0; i < places.size(); ++i) numbers.push_back((places[i] << 16) | static_cast<int>(i));
  std::uint32_t vectors = 1;
  while (4 * vectors < places.size()) vectors *= 2;
  numbers.resize(4 * vectors, kLastKey);
  auto keys = vectors_of<vec_int4>(numbers, kLastKey);
  auto values = keys;
  sort_network(keys.data(), values.data(), vectors);
  std::vector<int> kept = numbers_of<int>(values, remove_duplicates(keys.data(), values.data(), vectors));
  return kept.empty() ? kept : numbers_of<int>(values, kept.size());
}

TEST(ResidentDuplicates, TheDocumentsExampleKeepsFourIds) {
  const std::vector<int> kept = distinct({0, 3, 0, 4, 3, 4, 0, 1, 0});
  std::vector<int> ids;
  for (const int key : kept) ids.push_back(key >> 16);
  EXPECT_EQ(ids, (std::vector<int>{0, 1, 3, 4}));
}

TEST(ResidentDuplicates, TheFirstOfEqualPlacesStays) {
  Random random(6);
  for (std::size_t size = 1; size < 200; ++size) {
    std::vector<int> places(size);
    for (int& place : places) place = random.whole(0, random.one_in(2) ? 20 : 32766);
    std::map<int, int> first;
    for (std::size_t i = 0; i < size; ++i) first.emplace(places[i], static_cast<int>(i));
    std::vector<int> expected;
    for (const auto& [place, index] : first) expected.push_back((place << 16) | index);
    ASSERT_EQ(distinct(places), expected);
  }
}

TEST(ResidentSearch, EveryHintFindsWhatLowerBoundFinds) {
  Random random(7);
  for (std::size_t size = 0; size < 40; ++size) {
    std::vector<float> sorted(size);
    for (float& value : sorted) value = static_cast<float>(random.whole(-5, 5));
    std::sort(sorted.begin(), sorted.end());
    const auto vectors = vectors_of<vec_float4>(sorted, std::bit_cast<float>(kPaddingValueBits));
    for (int wanted = -6; wanted <= 6; ++wanted) {
      const auto value = static_cast<float>(wanted);
      const auto expected = std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin();
      for (std::uint32_t hint = 0; hint <= size; ++hint) {
        ASSERT_EQ(count_less(vectors.data(), static_cast<std::uint32_t>(vectors.size()), value, hint),
                  expected)
            << "of " << size << " values, hint " << hint;
      }
    }
  }
}

TEST(ResidentSortNetwork, OrderedBitsAreInTheOrderOfTheFloats) {
  const std::vector<float> ascending = {-FLT_MAX, -2.0F, -1.0F, -FLT_MIN, 0.0F, FLT_MIN, 1.0F, 1.5F, FLT_MAX};
  for (std::size_t i = 1; i < ascending.size(); ++i) {
    const int below = spu_extract(ordered_bits(spu_splats(ascending[i - 1])), 0);
    const int above = spu_extract(ordered_bits(spu_splats(ascending[i])), 0);
    EXPECT_LT(below, above) << ascending[i - 1] << " and " << ascending[i];
    EXPECT_LT(above, kLastKey);
  }
}

/// A sorted axis with its memory, and the same bodies in a map.
class AxisModel {
 public:
  static constexpr std::uint32_t kRoom = 64;

  explicit AxisModel(std::uint32_t axis) {
    sorted_ = {axis, 0, blocks_.data(), reach_.data(), places_.data()};
  }

  BodyBox box(Random& random, std::uint32_t slot) const {
    BodyBox result{};
    auto* words = reinterpret_cast<float*>(&result);
    for (int k = 0; k < 3; ++k) {
      words[k] = static_cast<float>(random.whole(-8, 8));
      words[4 + k] = words[k] + static_cast<float>(random.whole(0, random.one_in(9) ? 12 : 2));
    }
    set_tag(result, slot);
    return result;
  }

  void insert(Random& random, std::uint32_t count) {
    std::vector<BodyBox> boxes;
    std::vector<std::int32_t> order;
    for (std::uint32_t slot = 0; slot < kRoom && boxes.size() < count; ++slot) {
      if (bodies_.count(slot) != 0) continue;
      order.push_back(static_cast<std::int32_t>(boxes.size()));
      boxes.push_back(box(random, slot));
      bodies_[slot] = boxes.back();
    }
    std::sort(order.begin(), order.end(), [&](int a, int b) { return low(boxes[a]) < low(boxes[b]); });
    merge_bodies(sorted_, boxes.data(), order.data(), static_cast<std::uint32_t>(boxes.size()));
  }

  void move(Random& random) {
    std::uint32_t lowest = kRoom;
    for (auto& [slot, known] : bodies_) {
      if (!random.one_in(3)) continue;
      known = box(random, slot);
      lowest = std::min(lowest, move_body(sorted_, places_[slot], known));
    }
    refresh_reach(sorted_, lowest);
  }

  void remove(Random& random) {
    std::erase_if(bodies_, [&](const auto& body) {
      const bool gone = random.one_in(2);
      if (gone) set_tag_at(sorted_, places_[body.first], marked_tag(body.first, 3));
      return gone;
    });
    remove_marked(sorted_);
  }

  void check() const {
    ASSERT_EQ(sorted_.count, bodies_.size());
    float reach = -FLT_MAX;
    for (std::uint32_t place = 0; place < sorted_.count; ++place) {
      const BodyBox found = box_at(sorted_, place);
      ASSERT_EQ(places_[slot_of(found)], place);
      const auto known = bodies_.find(tag_of(found));
      ASSERT_NE(known, bodies_.end());
      ASSERT_EQ(std::memcmp(&found, &known->second, sizeof found), 0);
      ASSERT_LE(low(box_at(sorted_, place == 0 ? 0 : place - 1)), low(found));
      reach = std::max(reach, spu_extract(found.high, static_cast<int>(sorted_.axis)));
      const bool ends_block = place % 4 == 3 || place + 1 == sorted_.count;
      ASSERT_EQ(ends_block ? word_of_reach(place / 4) : reach, reach);
    }
    for (std::uint32_t block = sorted_.block_count(); block % 4 != 0; ++block) {
      ASSERT_EQ(std::bit_cast<std::uint32_t>(word_of_reach(block)), kPaddingValueBits);
    }
  }

 private:
  float low(const BodyBox& box) const { return spu_extract(box.low, static_cast<int>(sorted_.axis)); }
  float word_of_reach(std::uint32_t block) const {
    return reinterpret_cast<const float*>(reach_.data())[block];
  }

  std::vector<BoxBlock> blocks_ = std::vector<BoxBlock>(kRoom / 4);
  std::vector<vec_float4> reach_ = std::vector<vec_float4>(kRoom / 16);
  std::vector<std::uint16_t> places_ = std::vector<std::uint16_t>(kRoom);
  SortedAxis sorted_{};
  std::map<std::uint32_t, BodyBox> bodies_;
};

TEST(ResidentSortedAxis, StaysSortedThroughInsertsMovesAndRemoves) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    Random random(seed);
    AxisModel model(static_cast<std::uint32_t>(seed % 3));
    for (int step = 0; step < 12; ++step) {
      model.insert(random, static_cast<std::uint32_t>(random.below(20)));
      ASSERT_NO_FATAL_FAILURE(model.check()) << "insert, seed " << seed;
      model.move(random);
      ASSERT_NO_FATAL_FAILURE(model.check()) << "move, seed " << seed;
      model.remove(random);
      ASSERT_NO_FATAL_FAILURE(model.check()) << "remove, seed " << seed;
    }
  }
}

TEST(ResidentBodyBox, TouchingBoxesOverlapAndTagsDoNotMatter) {
  const auto body = [](float low, float high, std::uint32_t tag) {
    BodyBox box = {spu_splats(low), spu_splats(high)};
    set_tag(box, tag);
    return box;
  };
  EXPECT_TRUE(overlap(body(0, 1, 0xffffffff), body(1, 2, 0)));
  EXPECT_TRUE(overlap(body(0, 3, 0), body(1, 2, 0x7f7fffff)));
  EXPECT_FALSE(overlap(body(0, 1, 5), body(1.5F, 2, 5)));
  EXPECT_FALSE(overlap(body(1.5F, 2, 5), body(0, 1, 5)));
}

}  // namespace
}  // namespace cellsweep::cell
