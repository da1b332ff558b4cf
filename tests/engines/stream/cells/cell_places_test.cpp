/// @file
/// What workers put into cells lies cell by cell, that of one worker behind that of the one before.
#include "engines/stream/cells/cell_places.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>
#include <vector>

namespace cellsweep::stream {
namespace {

/// Something for a cell: from a worker, its number.
struct Item {
  std::uint32_t cell;
  unsigned worker;
  std::uint32_t number;

  friend bool operator==(const Item&, const Item&) = default;
};

/// In the order in which workers list them, one after the other.
std::vector<Item> random_items(std::mt19937& random, unsigned workers, std::uint32_t cells,
                               std::uint32_t most) {
  std::vector<Item> items;
  for (unsigned worker = 0; worker < workers; ++worker) {
    const auto count = static_cast<std::uint32_t>(random() % (most + 1));
    for (std::uint32_t number = 0; number < count; ++number)
      items.push_back({static_cast<std::uint32_t>(random() % cells), worker, number});
  }
  return items;
}

std::vector<Item> sorted_by_cell(std::vector<Item> items) {
  std::stable_sort(items.begin(), items.end(),
                   [](const Item& one, const Item& other) { return one.cell < other.cell; });
  return items;
}

void expect_places_of(const std::vector<Item>& items, unsigned workers, std::uint32_t cells) {
  Arena scratch;
  CellPlaces places(scratch, workers, cells);
  for (const Item& item : items) places.of(item.worker).count(item.cell);
  ASSERT_EQ(places.lay_out(), items.size());
  std::vector<Item> put(items.size());
  for (const Item& item : items) put.at(places.of(item.worker).next(item.cell)) = item;
  EXPECT_EQ(put, sorted_by_cell(items));
  std::uint32_t next = 0;
  for (const CellPlaces::Run& run : places.runs()) {
    ASSERT_EQ(run.first, next);
    ASSERT_GT(run.count, 0U);
    next += run.count;
    for (std::uint32_t place = run.first; place < next; ++place) EXPECT_EQ(put.at(place).cell, run.cell);
  }
  EXPECT_EQ(next, items.size());
}

TEST(CellPlaces, AreInTheOrderOfCellsAndWithinOneOfWorkers) {
  std::mt19937 random(1);
  for (const std::uint32_t cells : {1U, 2U, 63U, 64U, 65U, 128U, 511U, 512U, 513U, 5000U}) {
    for (const unsigned workers : {1U, 2U, 3U, 16U}) {
      for (const std::uint32_t most : {0U, 1U, 20U, 1000U})
        expect_places_of(random_items(random, workers, cells, most), workers, cells);
    }
  }
}

TEST(CellPlaces, AreNoneOfWhatTheMemoryHeldBefore) {
  Arena scratch;
  std::fill_n(scratch.take<std::uint8_t>(10'000), 10'000, std::uint8_t{0xff});
  scratch.release({});
  CellPlaces places(scratch, 2, 100);
  places.of(1).count(99);
  EXPECT_EQ(places.lay_out(), 1U);
  ASSERT_EQ(places.runs().size(), 1U);
  EXPECT_EQ(places.runs()[0].cell, 99U);
  EXPECT_EQ(places.of(1).next(99), 0U);
}

}  // namespace
}  // namespace cellsweep::stream
