// What a program wrote to its local store, counted and found by pages, is what looking at each byte says.
#include "isa/elf/program_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>

#include "spe/arena.h"

namespace spu_emu::isa {
namespace {

struct NoObserver final : StoreObserver {
  void store_written(std::uint32_t, std::uint32_t) noexcept override {}
};

/// A store with room for a program that ends at 1000, and up to `limit`.
struct PlacedStore {
  explicit PlacedStore(std::uint32_t limit) : arena(kHardwareSize) {
    settings.local_store_limit = limit;
    settings.stack_reserve = 0;
    program.end = 1000;
    EXPECT_EQ(store.emplace(arena, settings, observer).place(program), "");
  }

  std::uint32_t quadwords_behind_the_image() const {
    std::uint32_t written = 0;
    for (std::uint32_t at = 1008; at < store->limit(); at += 16) {
      const std::byte* const quadword = store->bytes() + at;
      if (std::any_of(quadword, quadword + 16, [](std::byte byte) { return byte != std::byte{}; })) ++written;
    }
    return written;
  }

  NoObserver observer;
  EmulationSettings settings;
  Arena arena;
  ElfProgram program;
  std::optional<ProgramStore> store;
};

TEST(ProgramStore, CountsTheQuadwordsThatWereWritten) {
  std::minstd_rand random(1);
  for (const std::uint32_t limit : {kHardwareSize, 200000U, 5008U}) {
    PlacedStore placed(limit);
    EXPECT_EQ(placed.store->bytes_in_use(), 1000U);
    for (int i = 0; i < 300; ++i) {
      placed.store->bytes()[1000 + random() % (limit - 1000)] = std::byte{1};
      EXPECT_EQ(placed.store->bytes_in_use(), 1000 + 16 * placed.quadwords_behind_the_image());
    }
  }
}

TEST(ProgramStore, NamesTheFirstByteBeyondItsLimitThatWasWritten) {
  for (const std::uint32_t limit : {200000U, 8192U, 5008U}) {
    PlacedStore placed(limit);
    placed.store->bytes()[limit - 1] = std::byte{1};
    EXPECT_EQ(placed.store->touched_beyond_limit(), std::nullopt);
    for (const std::uint32_t at : {kHardwareSize - 1, 250000U, 204800U, 204799U, limit}) {
      placed.store->bytes()[at] = std::byte{1};
      EXPECT_EQ(placed.store->touched_beyond_limit(), at);
    }
  }
}

}  // namespace
}  // namespace spu_emu::isa
