// Faults of running programs: what is reported, the libspe2 way, and what the fault says.
#include <sys/mman.h>

#include <csignal>

#include "test_context.h"

namespace spu_emu {
namespace {

void expect_text(spe_context_ptr_t spe, const char* part) {
  EXPECT_NE(last_fault(spe).find(part), std::string::npos) << part << " is not in: " << last_fault(spe);
}

TEST(HostFault, a_broken_dma_rule_is_a_runtime_exception_that_names_the_line) {
  TestContext context;
  const Words words;
  EXPECT_EQ(context.run(Probe::misaligned_get, &words), -1);
  EXPECT_EQ(errno, EIO);
  EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_RUNTIME_EXCEPTION});
  EXPECT_EQ(context.stop.result.spe_runtime_exception, SPE_DMA_ALIGNMENT);
  EXPECT_EQ(context.stop.spu_status, -1);
  expect_text(context.spe, "16-byte alignment");
  expect_text(context.spe, "probe_spu.cpp:");
}

void* page_with(int protection) {
  return mmap(nullptr, 4096, protection, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
}

class EveryDmaMode : public testing::TestWithParam<DmaMode> {};

TEST_P(EveryDmaMode, refuses_memory_that_is_not_there_or_not_to_be_written_and_the_process_goes_on) {
  TestContext context(settings_of(GetParam()));
  void* const unreadable = page_with(PROT_NONE);
  void* const unwritable = page_with(PROT_READ);
  for (int round = 0; round < 3; ++round) {
    EXPECT_EQ(context.run(Probe::sum_into_global, unreadable), -1);
    EXPECT_EQ(context.stop.result.spe_runtime_exception, SPE_DMA_STORAGE);
    expect_text(context.spe,
                "rule \"effective address\": this process has no memory there that can be read [get LS");
    expect_text(context.spe, "probe_spu.cpp:");
    EXPECT_EQ(context.run(Probe::put_constant, unwritable), -1);
    expect_text(context.spe, "this process has no memory there that can be written [put LS");
    const Words words;
    EXPECT_EQ(context.exit_code(Probe::sum_into_global, &words), words.sum());
  }
  EXPECT_EQ(*static_cast<int*>(unwritable), 0);
}

INSTANTIATE_TEST_SUITE_P(HostFault, EveryDmaMode, testing::Values(DmaMode::eager, DmaMode::late));

TEST(HostFault, without_events_enabled_a_broken_dma_rule_is_sigbus) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        TestContext context({}, 0);
        const Words words;
        std::signal(SIGBUS, SIG_DFL);
        context.run(Probe::misaligned_get, &words);
      },
      testing::KilledBySignal(SIGBUS), "16-byte alignment");
}

TEST(HostFault, a_bad_channel_and_a_halt_are_runtime_errors) {
  for (const unsigned int flags : {0U, unsigned{SPE_EVENTS_ENABLE}}) {
    TestContext context({}, flags);
    EXPECT_EQ(context.run(Probe::bad_channel), -1);
    EXPECT_EQ(errno, EFAULT);
    EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_RUNTIME_ERROR});
    EXPECT_EQ(context.stop.result.spe_runtime_error, SPE_SPU_INVALID_CHANNEL);
    EXPECT_EQ(context.run(Probe::halt), -1);
    EXPECT_EQ(context.stop.result.spe_runtime_error, SPE_SPU_HALT);
    expect_text(context.spe, "probe_spu.cpp");
  }
}

TEST(HostFault, a_program_that_faulted_cannot_be_resumed_but_started) {
  TestContext context;
  EXPECT_EQ(context.run(Probe::halt), -1);
  EXPECT_EQ(context.resume(), -1);
  EXPECT_EQ(errno, EINVAL);
  EXPECT_EQ(context.exit_code(Probe::return_parameter, 4), 4);
}

TEST(HostFault, a_pointer_outside_the_local_store_is_refused_with_advice) {
  TestContext context;
  const Words words;
  EXPECT_EQ(context.run(Probe::get_to_foreign_pointer, &words), -1);
  EXPECT_EQ(context.stop.result.spe_runtime_exception, SPE_INVALID_DMA);
  expect_text(context.spe, "_malloc_align");
}

TEST(HostFault, a_buffer_below_the_stack_reserve_is_refused_with_advice) {
  TestContext context;
  const Words words;
  EXPECT_EQ(context.run(Probe::get_to_deep_stack, &words), -1);
  EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_RUNTIME_FATAL});
  expect_text(context.spe, "stack_reserve");
  EmulationSettings settings;
  settings.stack_reserve = 64 * 1024;
  TestContext roomy(settings);
  EXPECT_EQ(roomy.exit_code(Probe::get_to_deep_stack, &words), 1);
}

TEST(HostFault, a_full_local_store_prints_its_map) {
  TestContext context;
  EXPECT_EQ(context.run(Probe::allocate_until_full, 50000), -1);
  EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_RUNTIME_FATAL});
  EXPECT_EQ(context.stop.result.spe_runtime_fatal, ENOMEM);
  for (const char* part : {"local store full", "50000", "code", "data", "heap", "block", "stack", "free"}) {
    expect_text(context.spe, part);
  }
}

TEST(HostFault, freeing_a_block_twice_is_refused) {
  TestContext context;
  EXPECT_EQ(context.run(Probe::free_twice), -1);
  expect_text(context.spe, "where no block begins");
}

TEST(HostFault, a_missing_wait_shows_in_late_mode) {
  const Words words;
  TestContext eager;
  EXPECT_EQ(eager.exit_code(Probe::read_without_waiting, &words), 1);
  if (kWithAsan) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_DEATH(
        {
          TestContext late(settings_of(DmaMode::late));
          late.run(Probe::read_without_waiting, &words);
        },
        "use-after-poison");
  } else {
    TestContext late(settings_of(DmaMode::late));
    EXPECT_EQ(late.exit_code(Probe::read_without_waiting, &words), 0);
  }
}

TEST(HostFault, writing_into_a_buffer_in_flight_is_reported_in_late_mode) {
  const Words words;
  TestContext late(settings_of(DmaMode::late));
  EXPECT_EQ(late.run(Probe::write_without_waiting, &words), -1);
  EXPECT_EQ(errno, EIO);
  expect_text(late.spe, "write into a get in flight");
  expect_text(late.spe, "probe_spu.cpp:");
}

}  // namespace
}  // namespace spu_emu
