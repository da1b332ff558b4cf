// Running programs: arguments, exit, stop and resume, private data, memory of every kind, rounding.
#include <xmmintrin.h>

#include <thread>
#include <vector>

#include "test_context.h"

namespace spu_emu {
namespace {

TEST(Run, the_exit_code_comes_back_in_the_stop_info) {
  TestContext context;
  ASSERT_EQ(context.load_result, 0);
  EXPECT_EQ(context.exit_code(Probe::return_parameter, 0x42), 0x42);
  EXPECT_EQ(context.stop.spu_status, (0x2042 << 16) | SPE_SPU_STOPPED_BY_STOP);
  EXPECT_EQ(context.exit_code(Probe::exit_with_parameter, 0x17), 0x17);
  EXPECT_EQ(context.exit_code(Probe::return_parameter, 0x1234), 0x34);
}

TEST(Run, the_program_gets_its_speid_and_ran_its_constructors) {
  TestContext context;
  EXPECT_EQ(context.exit_code(Probe::own_arguments, context.spe), 0);
}

TEST(Run, destructors_of_globals_run_at_exit) {
  for (const Probe probe : {Probe::return_parameter, Probe::exit_with_parameter}) {
    TestContext context;
    context.exit_code(probe);
    unsigned int message = 0;
    EXPECT_EQ(spe_out_mbox_read(context.spe, &message, 1), 1);
    EXPECT_EQ(message, 0x600dU);
  }
}

TEST(Run, user_registers_are_the_first_doublewords) {
  TestContext context;
  std::array<unsigned int, 12> registers{0, 1, 0, 0,  0, static_cast<unsigned int>(Probe::return_parameter),
                                         0, 0, 0, 77, 0, 0};
  EXPECT_EQ(spe_context_run(context.spe, &context.entry, SPE_RUN_USER_REGS, registers.data(), nullptr,
                            &context.stop),
            0);
  EXPECT_EQ(context.stop.result.spe_exit_code, 77);
}

TEST(Run, stop_and_signal_returns_the_code_and_can_be_resumed) {
  TestContext context;
  EXPECT_EQ(context.run(Probe::stop_twice), 0x123);
  EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_STOP_AND_SIGNAL});
  EXPECT_EQ(context.stop.result.spe_signal_code, 0x123);
  EXPECT_EQ(context.resume(), 0x124);
  EXPECT_EQ(context.resume(), 0);
  EXPECT_EQ(context.stop.result.spe_exit_code, 3);
}

TEST(Run, a_program_that_is_resumed_after_its_exit_exits_again_until_it_is_started) {
  TestContext context;
  EXPECT_EQ(context.exit_code(Probe::count_runs), 1);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(context.resume(), 0);
    EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_EXIT});
    EXPECT_EQ(context.stop.result.spe_exit_code, 1);
  }
  EXPECT_EQ(context.exit_code(Probe::count_runs), 2);
}

TEST(Run, user_registers_may_be_declared_as_doublewords) {
  EmulationSettings settings;
  settings.user_registers = UserRegisters::doublewords;
  TestContext context(settings);
  const unsigned long long probe = static_cast<unsigned long long>(Probe::return_parameter);
  std::array<unsigned long long, 6> registers{1, 0, probe, 0, 77, 0};
  EXPECT_EQ(spe_context_run(context.spe, &context.entry, SPE_RUN_USER_REGS, registers.data(), nullptr,
                            &context.stop),
            0);
  EXPECT_EQ(context.stop.result.spe_exit_code, 77);
  context.entry = SPE_DEFAULT_ENTRY;
  EXPECT_EQ(spe_context_run(context.spe, &context.entry, SPE_RUN_USER_REGS, nullptr, nullptr, &context.stop),
            -1);
  EXPECT_EQ(errno, EINVAL);
}

TEST(Run, a_stopped_program_may_go_on_on_another_thread) {
  TestContext context;
  EXPECT_EQ(context.run(Probe::stop_twice), 0x123);
  std::thread([&] { EXPECT_EQ(context.resume(), 0x124); }).join();
  EXPECT_EQ(context.resume(), 0);
}

TEST(Run, a_program_may_stop_while_it_handles_an_exception) {
  TestContext one;
  TestContext two;
  EXPECT_EQ(one.run(Probe::stop_inside_a_handler), 0x77);
  EXPECT_EQ(two.run(Probe::stop_inside_a_handler), 0x77);
  try {
    throw 1;
  } catch (int) {
    EXPECT_EQ(one.resume(), 0);
  }
  EXPECT_EQ(two.resume(), 0);
  EXPECT_EQ(one.stop.result.spe_exit_code, 56);
  EXPECT_EQ(two.stop.result.spe_exit_code, 56);
}

TEST(Run, a_stopped_program_may_be_destroyed_or_started_anew) {
  TestContext context;
  EXPECT_EQ(context.run(Probe::stop_twice), 0x123);
  EXPECT_EQ(context.exit_code(Probe::return_parameter, 5), 5);
  EXPECT_EQ(context.run(Probe::stop_twice), 0x123);
}

TEST(Run, contexts_of_one_program_share_no_data) {
  TestContext one;
  TestContext two;
  EXPECT_EQ(one.exit_code(Probe::count_runs), 1);
  EXPECT_EQ(one.exit_code(Probe::count_runs), 2);
  EXPECT_EQ(two.exit_code(Probe::count_runs), 1);
  EXPECT_EQ(spe_program_load(one.spe, &spu_emu_probe), 0);
  EXPECT_EQ(one.exit_code(Probe::count_runs), 1);
}

TEST(Run, dma_reaches_globals_stack_heap_and_constants_in_every_mode) {
  for (const DmaMode mode : {DmaMode::eager, DmaMode::late, DmaMode::unchecked}) {
    TestContext context(settings_of(mode));
    const Words words;
    EXPECT_EQ(context.exit_code(Probe::sum_into_global, &words), words.sum());
    EXPECT_EQ(context.exit_code(Probe::sum_into_stack, &words), words.sum());
    EXPECT_EQ(context.exit_code(Probe::sum_into_heap, &words), words.sum());
    EXPECT_EQ(context.exit_code(Probe::list_on_stack, &words), words.sum());
    Words target;
    EXPECT_EQ(context.exit_code(Probe::put_constant, &target), 0);
    EXPECT_EQ(target.words[2], 0x33333333U);
  }
}

TEST(Run, the_heap_functions_serve_from_the_local_store) {
  TestContext context;
  EXPECT_EQ(context.exit_code(Probe::use_the_heap), 0);
  EXPECT_GT(statistics(context.spe).local_store_high_water, 48U * 1024 + 16 * 1024 + 400);
}

TEST(Run, tags_are_reserved_in_each_context) {
  TestContext context;
  EXPECT_EQ(context.exit_code(Probe::reserve_tags), 0);
}

TEST(Run, the_spu_rounds_toward_zero_and_the_host_does_not) {
  TestContext context;
  const unsigned before = _mm_getcsr();
  EXPECT_EQ(context.exit_code(Probe::check_rounding), 0);
  EXPECT_EQ(_mm_getcsr(), before);
}

TEST(Run, a_put_without_a_wait_has_landed_when_the_program_stops) {
  for (const DmaMode mode : {DmaMode::eager, DmaMode::late}) {
    TestContext context(settings_of(mode));
    Words words;
    context.exit_code(Probe::put_without_waiting, &words);
    EXPECT_EQ(words.words[0], 0xabcdU);
  }
}

TEST(Run, statistics_count_what_the_program_did) {
  TestContext context(settings_of(DmaMode::late));
  const Words words;
  context.exit_code(Probe::many_gets, &words);
  const SpeStatistics done = statistics(context.spe);
  EXPECT_EQ(done.gets, 32U);
  EXPECT_EQ(done.bytes_in, 32U * 128);
  EXPECT_EQ(done.queue_stalls, 16U);
  EXPECT_EQ(done.tag_waits, 1U);
}

TEST(Run, refuses_what_cannot_run) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  EXPECT_EQ(spe_context_run(nullptr, &entry, 0, nullptr, nullptr, nullptr), -1);
  EXPECT_EQ(errno, ESRCH);
  spe_context_ptr_t empty = spe_context_create(0, nullptr);
  EXPECT_EQ(spe_context_run(empty, &entry, 0, nullptr, nullptr, nullptr), -1);
  EXPECT_EQ(errno, EINVAL);
  spe_context_destroy(empty);
  TestContext context;
  EXPECT_EQ(spe_context_run(context.spe, nullptr, 0, nullptr, nullptr, nullptr), -1);
  EXPECT_EQ(errno, EINVAL);
}

TEST(Run, many_contexts_run_at_once) {
  const Words words;
  std::vector<std::unique_ptr<TestContext>> contexts;
  for (int i = 0; i < 8; ++i) contexts.push_back(std::make_unique<TestContext>(settings_of(DmaMode::late)));
  std::vector<std::thread> threads;
  for (auto& context : contexts) {
    threads.emplace_back([&] {
      for (int i = 0; i < 20; ++i) EXPECT_EQ(context->exit_code(Probe::sum_into_global, &words), words.sum());
    });
  }
  for (auto& thread : threads) thread.join();
}

}  // namespace
}  // namespace spu_emu
