/// @file
/// What some slots have, against a plain map.
#include "base/memory/slot_blocks.h"

#include <gtest/gtest.h>

#include <map>

#include "base/memory/starved.h"
#include "contract/random.h"

namespace cellsweep {
namespace {

using Numbers = SlotBlocks<std::uint32_t>;

constexpr std::size_t kBlock = kSlotBlock;

/// These slots have their number and one.
Numbers numbers_in(std::size_t slots, std::initializer_list<Slot> some) {
  Numbers numbers;
  numbers.reserve(slots, some.size());
  for (const Slot slot : some) {
    EXPECT_TRUE(numbers.add(slot));
    numbers[slot] = slot + 1;
  }
  return numbers;
}

List<std::uint32_t> sevens(std::size_t count) {
  List<std::uint32_t> list;
  list.resize(count, 7);
  return list;
}

TEST(SlotBlocks, HaveNothingAtFirst) {
  const Numbers numbers;
  EXPECT_FALSE(numbers.are_by_slot());
  EXPECT_FALSE(numbers.has(0));
  EXPECT_FALSE(numbers.has(1'000'000));
  EXPECT_EQ(numbers.bytes(), 0U);
}

TEST(SlotBlocks, HaveWhatIsAdded) {
  Numbers numbers = numbers_in(10 * kBlock, {7 * kBlock + 3, 2 * kBlock + 5, 7 * kBlock});
  for (Slot slot = 0; slot < 12 * kBlock; ++slot)
    ASSERT_EQ(numbers.has(slot), slot == 7 * kBlock + 3 || slot == 2 * kBlock + 5 || slot == 7 * kBlock);
  EXPECT_FALSE(numbers.add(7 * kBlock)) << "it has something";
  EXPECT_EQ(numbers[7 * kBlock], 7 * kBlock + 1);
  EXPECT_EQ(numbers[7 * kBlock + 3], 7 * kBlock + 4);
  EXPECT_EQ(&numbers.blocks()[2][5], &numbers[2 * kBlock + 5]);
}

TEST(SlotBlocks, DoNotMoveWhenMoreAreAdded) {
  Numbers numbers = numbers_in(100'000, {5});
  const std::uint32_t* const place = &numbers[5];
  for (Slot slot = 0; slot < 100'000; slot += 100) {
    numbers.reserve(100'000, 1);
    numbers.add(slot);
  }
  EXPECT_EQ(&numbers[5], place);
  EXPECT_EQ(numbers[5], 6U);
}

TEST(SlotBlocks, TakeMemoryForThoseThatAreAddedAndLittleMore) {
  constexpr std::size_t kSlots = 1'000'000;
  Numbers numbers;
  numbers.reserve(kSlots, 1);
  const std::size_t of_one = numbers.bytes();
  EXPECT_LE(of_one, 2 * kSlots / kBlock * sizeof(void*) + kBlock * sizeof(std::uint32_t) + 100);
  numbers.reserve(kSlots, 1000);
  EXPECT_LE(numbers.bytes() - of_one, 1100 * (kBlock * sizeof(std::uint32_t) + 16));
  numbers = numbers_in(3 * kBlock, {});
  numbers.reserve(3 * kBlock, 1'000'000);
  EXPECT_LE(numbers.bytes(), 3 * kBlock * sizeof(std::uint32_t) + 200) << "no more than there are slots";
}

TEST(SlotBlocks, LieBySlotOnceAllDo) {
  Numbers numbers = numbers_in(1000, {999, 5});
  numbers.lay_by_slot(sevens(1000));
  EXPECT_TRUE(numbers.are_by_slot());
  EXPECT_EQ(numbers.blocks(), nullptr);
  EXPECT_EQ(numbers.all().size(), 1000U);
  EXPECT_EQ(numbers[5], 6U);
  EXPECT_EQ(numbers[999], 1000U);
  EXPECT_EQ(numbers[6], 7U);
  EXPECT_EQ(numbers[500], 7U);
  EXPECT_TRUE(numbers.has(500));
  EXPECT_FALSE(numbers.has(1000));
  EXPECT_EQ(numbers.bytes(), 1000 * sizeof(std::uint32_t));
}

TEST(SlotBlocks, SuitFewOfManySlots) {
  EXPECT_TRUE(Numbers::suit(0, 0));
  EXPECT_TRUE(Numbers::suit(1, 2 * kBlock));
  EXPECT_FALSE(Numbers::suit(1, 2 * kBlock - 1));
  EXPECT_FALSE(Numbers::suit(1000, 1000));
}

TEST(SlotBlocks, HoldWhatAMapHolds) {
  contract::Random random(1);
  for (int world = 0; world < 50; ++world) {
    Numbers numbers;
    std::map<Slot, std::uint32_t> known;
    std::size_t slots = 100;
    for (std::uint32_t round = 0; round < 500; ++round) {
      if (random.one_in(50)) slots += random.below(500);
      if (random.one_in(200)) {
        numbers.clear();
        known.clear();
      }
      const auto slot = static_cast<Slot>(random.below(slots));
      numbers.reserve(slots, 1);
      ASSERT_EQ(numbers.has(slot), known.contains(slot));
      ASSERT_EQ(numbers.add(slot), known.emplace(slot, round).second);
      numbers[slot] = known[slot] = round;
    }
    for (const auto& [slot, number] : known) ASSERT_EQ(numbers[slot], number);
    numbers.lay_by_slot(sevens(slots));
    for (Slot slot = 0; slot < slots; ++slot)
      ASSERT_EQ(numbers[slot], known.contains(slot) ? known[slot] : 7U);
  }
}

TEST(SlotBlocks, AreAsTheyWereWhereverMemoryEnds) {
  const auto make = [] { return numbers_in(1000, {5}); };
  const auto grow = [](Numbers& numbers) { numbers.reserve(1'000'000, 200); };
  const auto is_kept = [](const Numbers& numbers) {
    EXPECT_FALSE(numbers.has(6));
    EXPECT_FALSE(numbers.has(kBlock));
    EXPECT_EQ(numbers[5], 6U);
  };
  const auto is_done = [](Numbers& numbers) {
    for (Slot block = 1; block <= 200; ++block) EXPECT_TRUE(numbers.add(block * kBlock));
    EXPECT_EQ(numbers[5], 6U);
  };
  EXPECT_GE(starve(make, grow, is_kept, is_done), 5U);
}

}  // namespace
}  // namespace cellsweep
