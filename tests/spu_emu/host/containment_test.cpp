// Programs that go wrong as programs of any machine do: each ends with a sentence, and the process lives.
#include <libspe2.h>

#include <csignal>
#include <thread>
#include <vector>

#include "rogue.h"
#include "test_context.h"

extern "C" spe_program_handle_t spu_emu_rogue;

namespace spu_emu {
namespace {

using std::chrono_literals::operator""ms;

class RogueContext {
 public:
  explicit RogueContext(const EmulationSettings& settings = {}) {
    const SettingsScope scope(settings);
    spe = spe_context_create(SPE_EVENTS_ENABLE, nullptr);
    EXPECT_EQ(spe_program_load(spe, &spu_emu_rogue), 0) << last_fault(spe);
  }
  ~RogueContext() { EXPECT_EQ(spe_context_destroy(spe), 0); }
  RogueContext(const RogueContext&) = delete;
  RogueContext& operator=(const RogueContext&) = delete;

  int run(Rogue rogue, const void* parameter = nullptr) {
    unsigned int entry = SPE_DEFAULT_ENTRY;
    return spe_context_run(spe, &entry, 0, reinterpret_cast<void*>(rogue), const_cast<void*>(parameter),
                           &stop);
  }

  void expect_end(Rogue rogue, int value, const char* part, const void* parameter = nullptr) {
    SCOPED_TRACE(part);
    EXPECT_EQ(run(rogue, parameter), -1);
    EXPECT_EQ(errno, EFAULT);
    EXPECT_EQ(stop.stop_reason, unsigned{SPE_RUNTIME_FATAL});
    EXPECT_EQ(stop.result.spe_runtime_fatal, value);
    EXPECT_NE(last_fault(spe).find(part), std::string::npos) << last_fault(spe);
    EXPECT_NE(last_fault(spe).find("SPE "), std::string::npos) << last_fault(spe);
    spe_stop_info_t queued{};
    EXPECT_EQ(spe_stop_info_read(spe, &queued), 0);
    EXPECT_EQ(queued.stop_reason, unsigned{SPE_RUNTIME_FATAL});
    expect_still_good();
  }

  /// The same context runs its program again.
  void expect_still_good() {
    EXPECT_EQ(run(Rogue::nothing, reinterpret_cast<void*>(7)), 0) << last_fault(spe);
    EXPECT_EQ(stop.result.spe_exit_code, 7);
    spe_stop_info_t queued{};
    while (spe_stop_info_read(spe, &queued) == 0) continue;
  }

  spe_context_ptr_t spe = nullptr;
  spe_stop_info_t stop{};
};

EmulationSettings with_time_limit(std::chrono::milliseconds limit) {
  EmulationSettings settings;
  settings.time_limit = limit;
  return settings;
}

TEST(Containment, an_exception_that_leaves_main_ends_the_program_with_its_words) {
  RogueContext context;
  context.expect_end(Rogue::throw_exception, ECANCELED, "forgotten by the program");
  context.expect_end(Rogue::throw_number, ECANCELED, "no std::exception");
}

TEST(Containment, a_wait_without_an_end_ends_at_the_time_limit) {
  RogueContext context(with_time_limit(50ms));
  context.expect_end(Rogue::wait_for_a_mailbox, ETIMEDOUT,
                     "still waits when its time is over: read in mailbox");
  context.expect_end(Rogue::wait_for_an_event, ETIMEDOUT,
                     "still waits when its time is over: wait for events");
}

TEST(Containment, a_time_limit_that_cannot_be_is_refused) {
  EXPECT_THROW(set_default_settings(with_time_limit(-1ms)), std::invalid_argument);
  EXPECT_THROW(set_default_settings(with_time_limit(std::chrono::milliseconds::max())),
               std::invalid_argument);
}

TEST(Containment, bytes_written_behind_a_block_of_the_heap_end_the_program_when_it_frees_the_block_or_exits) {
  RogueContext context;
  context.expect_end(Rogue::overrun_a_block, EFAULT, "behind the 28 bytes that it asked for at LS 0x");
  context.expect_end(Rogue::overrun_a_freed_block, EFAULT, "program wrote to LS 0x");
  const Words words;
  context.expect_end(Rogue::overrun_a_block_by_dma, EFAULT, "behind the 112 bytes", words.words.data());
}

TEST(Containment, bytes_written_up_to_the_next_quadword_are_a_block_s_own) {
  RogueContext context;
  EXPECT_EQ(context.run(Rogue::overrun_a_block, reinterpret_cast<void*>(5)), 0) << last_fault(context.spe);
  EXPECT_EQ(context.stop.result.spe_exit_code, 5);
}

// A sanitizer reports what follows itself, and ends the process.
#ifndef SPU_EMU_SANITIZED_TESTS

TEST(Containment, a_bad_address_ends_the_program_and_is_named) {
  RogueContext context;
  context.expect_end(Rogue::write_to_null, EFAULT, "used address 0x0, where it has no memory, at 0x");
  context.expect_end(Rogue::jump_to_null, EFAULT, "used address 0x0");
  context.expect_end(Rogue::copy_to_null, EFAULT, "used address 0x0");
  context.expect_end(Rogue::fault_inside_a_handler, EFAULT, "used address 0x0");
}

TEST(Containment, an_overrun_of_the_local_store_ends_the_program_with_its_ls_address) {
  RogueContext context;
  context.expect_end(Rogue::write_beyond_the_store, EFAULT,
                     "used LS 0x40010, beyond the 262144 bytes of its local store");
  context.expect_end(Rogue::overrun_the_heap, EFAULT, "used LS 0x40000");
}

TEST(Containment, endless_recursion_ends_the_program_at_its_stack_s_end) {
  RogueContext context;
  context.expect_end(Rogue::recurse, ENOMEM, "used up the 1048576 bytes of its stack");
  const Words words;
  context.expect_end(Rogue::recurse_with_dma, ENOMEM, "bytes on its stack and may have 983040",
                     words.words.data());
}

TEST(Containment, more_than_the_stated_stack_is_a_fault_in_late_mode) {
  const Words words;
  RogueContext context(settings_of(DmaMode::late));
  context.expect_end(Rogue::recurse_with_dma, ENOMEM, "may have 16384; raise stack_reserve",
                     words.words.data());
  EmulationSettings roomy = settings_of(DmaMode::late);
  roomy.stack_reserve = 64 * 1024;
  RogueContext roomy_context(roomy);
  roomy_context.expect_end(Rogue::recurse_with_dma, ENOMEM, "may have 65536; raise stack_reserve",
                           words.words.data());
}

TEST(Containment, arithmetic_that_has_no_result_ends_the_program) {
  RogueContext context;
  context.expect_end(Rogue::divide_by_zero, EDOM, "divided an integer by zero");
  context.expect_end(Rogue::divide_lowest_by_minus_one, EDOM, "or the lowest by -1");
}

TEST(Containment, abort_and_what_calls_it_end_the_program) {
  RogueContext context;
  context.expect_end(Rogue::abort, ECANCELED, "called abort()");
  context.expect_end(Rogue::fail_assertion, ECANCELED, "called abort()");
  context.expect_end(Rogue::throw_out_of_noexcept, ECANCELED, "called abort()");
}

TEST(Containment, what_is_no_instruction_is_a_runtime_error_as_on_the_spu) {
  RogueContext context;
  EXPECT_EQ(context.run(Rogue::run_into_no_instruction), -1);
  EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_RUNTIME_ERROR});
  EXPECT_EQ(context.stop.result.spe_runtime_error, SPE_SPU_INVALID_INSTR);
  EXPECT_NE(last_fault(context.spe).find("no instruction"), std::string::npos) << last_fault(context.spe);
  context.expect_still_good();
}

TEST(Containment, a_loop_without_an_end_ends_at_the_time_limit) {
  RogueContext context(with_time_limit(50ms));
  context.expect_end(Rogue::loop, ETIMEDOUT, "has run for 50 ms and has not ended, at 0x");
  context.expect_end(Rogue::loop_over_the_c_library, ETIMEDOUT, "has run for 50 ms");
}

TEST(Containment, a_loop_ends_at_the_time_limit_in_a_thread_that_blocks_all_signals) {
  std::thread([] {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, nullptr);
    RogueContext context(with_time_limit(50ms));
    context.expect_end(Rogue::loop, ETIMEDOUT, "has run for 50 ms");
    context.expect_end(Rogue::write_to_null, EFAULT, "used address 0x0");
    sigset_t after;
    pthread_sigmask(SIG_SETMASK, nullptr, &after);
    EXPECT_EQ(sigismember(&after, SIGSEGV), 1);
  }).join();
}

TEST(Containment, many_programs_fail_at_once_each_with_its_own_sentence) {
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([i] {
      RogueContext context;
      for (int round = 0; round < 20; ++round) {
        if (i % 2 == 0)
          context.expect_end(Rogue::recurse, ENOMEM, "stack");
        else
          context.expect_end(Rogue::divide_by_zero, EDOM, "divided");
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

void fault_of_the_host() {
  volatile char* volatile nowhere = nullptr;
  *nowhere = 1;
}

TEST(Containment, a_bad_address_of_the_host_itself_ends_the_process_as_ever) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        RogueContext context;
        context.run(Rogue::write_to_null);
        fault_of_the_host();
      },
      testing::KilledBySignal(SIGSEGV), "");
}

TEST(Containment, a_handler_that_was_there_before_gets_what_is_no_program_s) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        std::signal(SIGSEGV, [](int) { _exit(42); });
        RogueContext context;
        if (context.run(Rogue::write_to_null) == -1) fault_of_the_host();
      },
      testing::ExitedWithCode(42), "");
}

TEST(Containment, without_it_the_program_s_fault_ends_the_process) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        EmulationSettings settings;
        settings.contain_faults = false;
        RogueContext context(settings);
        context.run(Rogue::write_to_null);
      },
      testing::KilledBySignal(SIGSEGV), "");
}

#endif

}  // namespace
}  // namespace spu_emu
