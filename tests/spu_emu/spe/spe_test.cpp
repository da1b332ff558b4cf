// An SPE and the program that a loader gives it, of no engine.
#include "spe/spe.h"

#include <gtest/gtest.h>

#include <array>
#include <cerrno>
#include <new>
#include <span>

namespace spu_emu {
namespace {

/// Exits with its first argument, and has a local store of its own.
class FakeProgram final : public Program {
 public:
  LocalStoreView& store() override { return store_; }
  std::uint32_t store_size() const override { return kSize; }
  Stop start(const Arguments& arguments) override {
    return {Stop::Kind::exit, static_cast<unsigned int>(arguments.argp), 0, {}};
  }
  Stop resume(unsigned int entry) override { return {Stop::Kind::signal, entry, 0, {}}; }
  bool can_resume(unsigned int) const override { return true; }
  unsigned int resume_entry() const override { return 0; }
  unsigned int entry_after_call() const override { return 0; }
  int serve_library_call(const Stop&) override { return 0; }
  std::uint32_t high_water() const override { return 100; }
  std::string map() const override { return "fake map\n"; }

 private:
  static constexpr std::uint32_t kSize = 4096;
  std::array<std::byte, kSize> bytes_{};
  FlatLocalStore store_{bytes_.data(), kSize, WordOrder::same};
};

LoadResult load_fake(Spe&, const ProgramImage&) {
  return {std::make_unique<FakeProgram>(), 0, {}};
}
LoadResult load_nothing(Spe&, const ProgramImage&) {
  return {nullptr, EINVAL, "no fake"};
}
LoadResult load_without_memory(Spe&, const ProgramImage&) {
  throw std::bad_alloc();
}

constexpr ProgramImage kImage;

TEST(Spe, runs_what_its_loader_made) {
  Spe spe({}, 0, nullptr);
  EXPECT_FALSE(spe.loaded());
  ASSERT_EQ(spe.load(kImage, &load_fake), 0);
  ASSERT_TRUE(spe.loaded());
  EXPECT_EQ(spe.store_size(), 4096U);
  EXPECT_EQ(spe.store_map(), "fake map\n");
  EXPECT_EQ(spe.statistics().local_store_high_water, 100U);
  Arguments arguments;
  arguments.argp = 7;
  const Stop stop = spe.start(arguments);
  EXPECT_EQ(stop.kind, Stop::Kind::exit);
  EXPECT_EQ(stop.code, 7U);
  EXPECT_EQ(spe.resume(12).code, 12U);
}

TEST(Spe, has_its_whole_local_store_while_nothing_is_loaded) {
  Spe spe({}, 0, nullptr);
  EXPECT_EQ(spe.store_size(), 0x40000U);
  EXPECT_NE(spe.store_map().find("no program is loaded"), std::string::npos);
  EXPECT_EQ(spe.statistics().local_store_high_water, 0U);
}

TEST(Spe, has_nothing_loaded_and_a_reason_after_its_loader_failed) {
  Spe spe({}, 0, nullptr);
  ASSERT_EQ(spe.load(kImage, &load_fake), 0);
  EXPECT_EQ(spe.load(kImage, &load_nothing), EINVAL);
  EXPECT_FALSE(spe.loaded());
  EXPECT_EQ(spe.last_fault(), "no fake");
  EXPECT_EQ(spe.load(kImage, &load_without_memory), ENOMEM);
  EXPECT_EQ(spe.last_fault(), "no memory for the program");
}

}  // namespace
}  // namespace spu_emu
