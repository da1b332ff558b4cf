// The SDK's libraries as SPU and host programs use them, on both engines.
#include <gtest/gtest.h>
#include <libmisc.h>
#include <libspe2.h>
#include <libsync.h>
#include <spu_emu/emulation.h>

#include <cstdint>
#include <thread>
#include <vector>

#include "sdk_libraries/shared.h"

extern "C" spe_program_handle_t sync_program;
extern "C" spe_program_handle_t sdk_headers_program;
#ifdef SPU_EMU_HAS_ELF
extern "C" spe_program_handle_t sync_program_elf;
extern "C" spe_program_handle_t sdk_headers_program_elf;
#endif

namespace {

struct Engine {
  const char* name;
  spe_program_handle_t* sync;
  spe_program_handle_t* headers;
};

int run(spe_program_handle_t* program, void* argument) {
  spe_context_ptr_t spe = spe_context_create(0, nullptr);
  spe_stop_info_t stop{};
  unsigned entry = SPE_DEFAULT_ENTRY;
  const bool ran = spe != nullptr && spe_program_load(spe, program) == 0 &&
                   spe_context_run(spe, &entry, 0, argument, nullptr, &stop) == 0 && stop.stop_reason == SPE_EXIT;
  EXPECT_TRUE(ran) << (spe != nullptr ? spu_emu::last_fault(spe) : "");
  if (spe != nullptr) spe_context_destroy(spe);
  return ran ? stop.result.spe_exit_code : -1;
}

class SdkLibraries : public testing::TestWithParam<Engine> {};

TEST_P(SdkLibraries, AllHeadersWorkInOneSpuProgram) {
  EXPECT_EQ(run(GetParam().headers, nullptr), 0);
}

TEST_P(SdkLibraries, SpesAndHostWaitForEachOtherAndCountWithoutLoss) {
  constexpr int kSpes = 3;
  alignas(128) static SharedState state;
  state = SharedState{};
  const auto address = reinterpret_cast<std::uintptr_t>(&state);
  alignas(16) SharedJob job{static_cast<unsigned>(address >> 32U), static_cast<unsigned>(address), {}};
  std::vector<std::thread> spes;
  std::vector<int> codes(kSpes, -1);
  write_lock(&state.lock);
  for (int i = 0; i < kSpes; ++i) {
    spes.emplace_back([&, i] { codes[i] = run(GetParam().sync, &job); });
  }
  mutex_lock(&state.mutex);
  state.go.value = 1;
  mutex_unlock(&state.mutex);
  cond_broadcast(&state.condition);
  write_unlock(&state.lock);
  for (int i = 0; i < kRounds; ++i) {
    atomic_add(1, &state.counter);
    mutex_lock(&state.mutex);
    ++state.guarded.value;
    mutex_unlock(&state.mutex);
  }
  for (int i = 0; i < kSpes; ++i) wait_for_completion(&state.completion);
  for (auto& spe : spes) spe.join();
  EXPECT_EQ(codes, std::vector<int>(kSpes, 0));
  EXPECT_EQ(atomic_read(&state.counter), (kSpes + 1) * kRounds);
  EXPECT_EQ(state.guarded.value, (kSpes + 1) * kRounds);
  EXPECT_EQ(state.lock.value, 0);
}

std::vector<Engine> engines() {
  return {
      {"host", &sync_program, &sdk_headers_program},
#ifdef SPU_EMU_HAS_ELF
      {"isa", &sync_program_elf, &sdk_headers_program_elf},
#endif
  };
}

INSTANTIATE_TEST_SUITE_P(On, SdkLibraries, testing::ValuesIn(engines()),
                         [](const auto& test) { return test.param.name; });

TEST(LibmiscOfTheHost, GivesAlignedMemoryAndTakesItBack) {
  for (unsigned log2 = 0; log2 <= 16; ++log2) {
    void* block = calloc_align(3, 100, log2);
    ASSERT_NE(block, nullptr);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(block) % (1UL << log2), 0U);
    static_cast<char*>(block)[299] = 1;
    block = realloc_align(block, 5000, log2);
    EXPECT_EQ(static_cast<char*>(block)[299], 1);
    EXPECT_EQ(realloc_align(block, 0, log2), nullptr);
  }
  EXPECT_EQ(malloc_align(SIZE_MAX - 5, 7), nullptr);
  EXPECT_EQ(malloc_align(1, 64), nullptr);
  EXPECT_EQ(calloc_align(SIZE_MAX / 2, 3, 4), nullptr);
}

TEST(LibsyncOfTheHost, CountersSayWhatTheyWere) {
  int counter = 5;
  EXPECT_EQ(atomic_dec_if_positive(&counter), 4);
  atomic_set(&counter, 0);
  EXPECT_EQ(atomic_dec_if_positive(&counter), -1);
  EXPECT_EQ(counter, 0);
  EXPECT_EQ(atomic_add_return(7, &counter), 7);
  EXPECT_EQ(atomic_sub_and_test(7, &counter), 1);
  EXPECT_EQ(atomic_inc_return(&counter), 1);
  EXPECT_EQ(atomic_dec_and_test(&counter), 1);
  int mutex = 0;
  EXPECT_EQ(mutex_trylock(&mutex), 1);
  EXPECT_EQ(mutex_trylock(&mutex), 0);
  mutex_unlock(&mutex);
  int lock = 0;
  EXPECT_EQ(read_trylock(&lock), 1);
  EXPECT_EQ(write_trylock(&lock), 0);
  read_unlock(&lock);
  EXPECT_EQ(write_trylock(&lock), 1);
  EXPECT_EQ(read_trylock(&lock), 0);
}

}  // namespace
