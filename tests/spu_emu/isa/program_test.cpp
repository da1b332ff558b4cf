// Real SPU code under libspe2: loading, arguments, stops, DMA with swapped words, limits, faults.
#include <sys/mman.h>

#include <cerrno>
#include <csignal>
#include <thread>

#include "isa_context.h"
#include "mfc/byte_order.h"
#include "spu_emu/mfc_opcodes.h"

namespace spu_emu::isa {
namespace {

const std::uint32_t kExit = stop_with(0x2000);

TEST(IsaProgram, the_exit_code_comes_back_in_the_stop_info) {
  IsaContext context(Code{stop_with(0x2017)});
  ASSERT_EQ(context.load_result, 0) << last_fault(context.spe);
  EXPECT_EQ(context.run(), 0);
  EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_EXIT});
  EXPECT_EQ(context.stop.result.spe_exit_code, 0x17);
  EXPECT_EQ(context.stop.spu_status, (0x2017 << 16) | SPE_SPU_STOPPED_BY_STOP);
}

TEST(IsaProgram, a_program_goes_on_behind_its_exit) {
  IsaContext context(
      Code{encode("ai", {20, 20, 1}), stop_with(0x2017), encode("stqa", {20, 0x200}), stop_with(0x111)});
  EXPECT_EQ(context.run(), 0);
  EXPECT_EQ(context.resume(), 0x111);
  EXPECT_EQ(context.word(0x200), 1U);
}

TEST(IsaProgram, the_entry_of_the_file_by_its_number_is_a_start_with_arguments) {
  IsaContext context(Code{encode("stqa", {4, 0x200}), stop_with(1), kExit});
  EXPECT_EQ(context.run(reinterpret_cast<void*>(7)), 1);
  context.entry = 0x80;
  EXPECT_EQ(
      spe_context_run(context.spe, &context.entry, 0, reinterpret_cast<void*>(8), nullptr, &context.stop), 1);
  EXPECT_EQ(read_doubleword(context.local_store() + 0x200), 8U);
}

TEST(IsaProgram, user_registers_may_be_declared_as_doublewords) {
  EmulationSettings settings;
  settings.user_registers = UserRegisters::doublewords;
  IsaContext context(Code{encode("stqa", {3, 0x200}), encode("stqa", {5, 0x210}), kExit}, settings);
  std::array<unsigned long long, 6> registers{0x123456789abcdef0U, 2, 3, 4, 5, 0xf00000000U};
  EXPECT_EQ(context.run(registers.data(), SPE_RUN_USER_REGS), 0);
  EXPECT_EQ(read_doubleword(context.local_store() + 0x200), registers[0]);
  EXPECT_EQ(read_doubleword(context.local_store() + 0x208), 2U);
  EXPECT_EQ(read_doubleword(context.local_store() + 0x218), registers[5]);
}

volatile std::sig_atomic_t signals_taken = 0;

TEST(IsaProgram, without_events_a_signal_tells_and_its_handler_interrupts_the_run) {
  const auto expect_signal = [](const Code& code, int signal, const void* argp) {
    signals_taken = 0;
    struct sigaction before {};
    struct sigaction action {};
    action.sa_handler = [](int) { signals_taken = signals_taken + 1; };
    sigaction(signal, &action, &before);
    IsaContext context(code, {}, 0);
    EXPECT_EQ(context.run(argp), -1);
    EXPECT_EQ(errno, EFAULT);
    EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_RUNTIME_FATAL});
    EXPECT_EQ(context.stop.result.spe_runtime_fatal, EINTR);
    EXPECT_EQ(context.stop.spu_status, -1);
    EXPECT_EQ(signals_taken, 1);
    sigaction(signal, &before, nullptr);
  };
  Code misaligned;
  append_dma(misaligned, MFC_GET_CMD, 0x1004, 16);
  Code unmapped;
  append_wait(append_dma(unmapped, MFC_GET_CMD, 0x1000, 16));
  expect_signal(Code{0x01400000}, SIGILL, nullptr);
  expect_signal(misaligned, SIGBUS, nullptr);
  expect_signal(unmapped, SIGSEGV, reinterpret_cast<const void*>(0x1000));
}

TEST(IsaProgram, the_context_has_the_local_store_of_the_hardware) {
  IsaContext context(Code{kExit});
  EXPECT_EQ(spe_ls_size_get(context.spe), 256 * 1024);
  EXPECT_EQ(context.word(0x80), kExit);
  EXPECT_NE(local_store_map(context.spe).find("132 bytes of code and data"), std::string::npos)
      << local_store_map(context.spe);
}

TEST(IsaProgram, arguments_are_doublewords_in_r3_to_r5) {
  IsaContext context(
      Code{encode("stqa", {3, 0x200}), encode("stqa", {4, 0x210}), encode("stqa", {6, 0x220}), kExit});
  EXPECT_EQ(context.run(reinterpret_cast<void*>(0x123456789abc)), 0);
  EXPECT_EQ(read_doubleword(context.local_store() + 0x200), reinterpret_cast<std::uintptr_t>(context.spe));
  EXPECT_EQ(read_doubleword(context.local_store() + 0x210), 0x123456789abcU);
  EXPECT_EQ(read_doubleword(context.local_store() + 0x220),
            reinterpret_cast<std::uintptr_t>(context.local_store()));
}

TEST(IsaProgram, user_registers_are_three_quadwords) {
  IsaContext context(Code{encode("stqa", {3, 0x200}), encode("stqa", {5, 0x210}), kExit});
  std::array<unsigned int, 12> registers{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  EXPECT_EQ(context.run(registers.data(), SPE_RUN_USER_REGS), 0);
  EXPECT_EQ(context.word(0x20c), 4U);
  EXPECT_EQ(context.word(0x210), 9U);
}

TEST(IsaProgram, a_stop_keeps_registers_and_can_be_resumed_on_another_thread) {
  IsaContext context(
      Code{encode("il", {20, 77}), stop_with(0x123), encode("stqa", {20, 0x200}), stop_with(0x124), kExit});
  EXPECT_EQ(context.run(), 0x123);
  EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_STOP_AND_SIGNAL});
  EXPECT_EQ(context.stop.result.spe_signal_code, 0x123);
  EXPECT_EQ(context.entry, 0x88U);
  std::thread([&] { EXPECT_EQ(context.resume(), 0x124); }).join();
  EXPECT_EQ(context.word(0x200), 77U);
  EXPECT_EQ(context.resume(), 0);
  EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_EXIT});
}

TEST(IsaProgram, a_stopped_program_goes_on_at_any_instruction_that_the_host_names) {
  IsaContext context(Code{stop_with(1), stop_with(2), stop_with(3), kExit});
  EXPECT_EQ(context.run(), 1);
  context.entry += 4;
  EXPECT_EQ(context.resume(), 3);
  context.entry = 0x82;
  EXPECT_EQ(context.resume(), -1);
  EXPECT_EQ(errno, EINVAL);
  context.entry = 0x40000;
  EXPECT_EQ(context.resume(), -1);
}

TEST(IsaProgram, code_that_the_host_writes_while_it_stands_still_is_executed) {
  IsaContext context(Code{stop_with(1), stop_with(2), kExit});
  EXPECT_EQ(context.run(), 1);
  const unsigned int again = context.entry;
  EXPECT_EQ(context.resume(), 2);
  write_word(context.local_store() + again, stop_with(9));
  context.entry = again;
  EXPECT_EQ(context.resume(), 9);
}

TEST(IsaProgram, starting_again_keeps_memory_as_the_hardware_does) {
  IsaContext context(
      Code{encode("lqa", {20, 0x200}), encode("ai", {20, 20, 1}), encode("stqa", {20, 0x200}), kExit});
  for (unsigned run = 1; run <= 3; ++run) {
    EXPECT_EQ(context.run(), 0);
    EXPECT_EQ(context.word(0x200), run);
  }
}

TEST(IsaProgram, dma_swaps_the_bytes_of_each_word_both_ways_in_every_mode) {
  for (const DmaMode mode : {DmaMode::eager, DmaMode::late, DmaMode::unchecked}) {
    EmulationSettings settings;
    settings.dma_mode = mode;
    Code code;
    append_wait(append_dma(code, MFC_GET_CMD, 0x1000, 64));
    code.push_back(encode("lqa", {20, 0x1000}));
    code.push_back(encode("ai", {20, 20, 1}));
    code.push_back(encode("stqa", {20, 0x1000}));
    append_wait(append_dma(code, MFC_PUT_CMD, 0x1000, 16));
    code.push_back(kExit);
    IsaContext context(code, settings);
    MainWords memory;
    EXPECT_EQ(context.run(&memory), 0) << last_fault(context.spe);
    EXPECT_EQ(context.word(0x1010), 0x10111213U);
    EXPECT_EQ(context.local_store()[0x1010], std::byte{0x10});
    EXPECT_EQ(memory.words[0], 0x00010204U);
    EXPECT_EQ(memory.words[4], 0x10111213U);
    EXPECT_EQ(statistics(context.spe).bytes_in, 64U);
  }
}

TEST(IsaProgram, a_buffer_read_before_the_wait_holds_poison_in_late_mode) {
  EmulationSettings settings;
  settings.dma_mode = DmaMode::late;
  Code code;
  append_dma(code, MFC_GET_CMD, 0x1000, 16);
  code.push_back(encode("lqa", {20, 0x1000}));
  code.push_back(encode("stqa", {20, 0x2000}));
  append_wait(code);
  code.push_back(kExit);
  IsaContext context(code, settings);
  const MainWords memory;
  EXPECT_EQ(context.run(&memory), 0) << last_fault(context.spe);
  EXPECT_EQ(context.word(0x2000), 0xa5a5a5a5U);
  EXPECT_EQ(context.word(0x1000), 0x00010203U);
}

TEST(IsaProgram, code_that_comes_by_dma_is_executed) {
  for (const DmaMode mode : {DmaMode::eager, DmaMode::late}) {
    EmulationSettings settings;
    settings.dma_mode = mode;
    // The old code at 0x1000 runs once before it is replaced.
    Code code;
    append_wait(append_dma(code, MFC_GET_CMD, 0x1000, 16));
    code.push_back(encode("bra", {0x1000}));
    IsaContext context(ElfBuilder(0x1000, {{0x80, code}, {0x1000, {encode("bra", {0x80}), 0, 0, 0}}}).build(),
                       settings);
    MainWords memory;
    memory.words[0] = stop_with(0x2005);
    EXPECT_EQ(context.run(&memory), 0) << last_fault(context.spe);
    EXPECT_EQ(context.stop.result.spe_exit_code, 5);
  }
}

TEST(IsaProgram, an_atomic_update_swaps_words_too) {
  Code code;
  append_dma(code, MFC_GETLLAR_CMD, 0x1000, 128);
  code.push_back(encode("rdch", {12, 27}));
  code.push_back(encode("lqa", {20, 0x1000}));
  code.push_back(encode("ai", {20, 20, 1}));
  code.push_back(encode("stqa", {20, 0x1000}));
  append_dma(code, MFC_PUTLLC_CMD, 0x1000, 128);
  code.push_back(encode("rdch", {12, 27}));
  code.push_back(kExit);
  IsaContext context(code);
  MainWords memory;
  EXPECT_EQ(context.run(&memory), 0) << last_fault(context.spe);
  EXPECT_EQ(memory.words[0], 0x00010204U);
  EXPECT_EQ(memory.words[31], 0x7c7d7e7fU);
}

TEST(IsaProgram, between_two_local_stores_nothing_is_swapped) {
  Code code;
  append_wait(append_dma(code, MFC_PUT_CMD, 0x80, 16));
  code.push_back(kExit);
  IsaContext from(code);
  IsaContext to(Code{kExit});
  EXPECT_EQ(from.run(to.local_store() + 0x3000), 0) << last_fault(from.spe);
  EXPECT_EQ(to.word(0x3000), code[0]);
  EXPECT_EQ(to.word(0x300c), code[3]);
}

TEST(IsaProgram, a_local_store_of_this_machines_order_gets_swapped_words) {
  Code code;
  append_wait(append_dma(code, MFC_PUT_CMD, 0x80, 16));
  code.push_back(kExit);
  IsaContext from(code);
  spe_context_ptr_t to = spe_context_create(0, nullptr);
  ASSERT_NE(to, nullptr);
  auto* words = static_cast<std::uint32_t*>(spe_ls_area_get(to));
  EXPECT_EQ(from.run(words), 0) << last_fault(from.spe);
  EXPECT_EQ(words[0], code[0]);
  EXPECT_EQ(words[3], code[3]);
  EXPECT_EQ(spe_context_destroy(to), 0);
}

TEST(IsaProgram, loads_and_stores_of_the_host_reach_a_mapped_problem_state) {
  IsaContext context(Code{encode("rdch", {20, 29}), encode("ai", {20, 20, 1}), encode("wrch", {28, 20}),
                          encode("rdch", {21, 3}), stop_with(0x2007)},
                     {}, SPE_MAP_PS | SPE_EVENTS_ENABLE);
  auto* control =
      static_cast<volatile spe_spu_control_area_t*>(spe_ps_area_get(context.spe, SPE_CONTROL_AREA));
  auto* signal =
      static_cast<volatile spe_sig_notify_1_area_t*>(spe_ps_area_get(context.spe, SPE_SIG_NOTIFY_1_AREA));
  ASSERT_NE(control, nullptr);
  std::thread spu([&] { EXPECT_EQ(context.run(), 0); });
  control->SPU_In_Mbox = 0x01020304;
  while ((control->SPU_Mbox_Stat & 0xffU) == 0) std::this_thread::yield();
  EXPECT_EQ(control->SPU_Out_Mbox, 0x01020305U);
  EXPECT_EQ(control->SPU_Status, 1U);
  signal->SPU_Sig_Notify_1 = 5;
  spu.join();
  EXPECT_EQ(control->SPU_Status, 0x20070002U);
}

TEST(IsaProgram, mailboxes_and_signals_carry_values) {
  IsaContext context(Code{encode("rdch", {20, 29}), encode("rdch", {21, 3}), encode("a", {20, 20, 21}),
                          encode("wrch", {28, 20}), kExit});
  std::thread spu([&] { EXPECT_EQ(context.run(), 0); });
  unsigned int message = 0x01020304;
  EXPECT_EQ(spe_in_mbox_write(context.spe, &message, 1, SPE_MBOX_ALL_BLOCKING), 1);
  EXPECT_EQ(spe_signal_write(context.spe, SPE_SIG_NOTIFY_REG_1, 0x10), 0);
  spu.join();
  EXPECT_EQ(spe_out_mbox_read(context.spe, &message, 1), 1);
  EXPECT_EQ(message, 0x01020314U);
}

TEST(IsaProgram, the_proxy_queue_swaps_words) {
  IsaContext context(Code{kExit});
  MainWords memory;
  EXPECT_EQ(spe_mfcio_get(context.spe, 0x1000, memory.words.data(), 128, 1, 0, 0), 0);
  unsigned int done = 0;
  EXPECT_EQ(spe_mfcio_tag_status_read(context.spe, 0, SPE_TAG_ALL, &done), 0);
  EXPECT_EQ(context.word(0x1004), 0x04050607U);
}

TEST(IsaProgram, an_illegal_instruction_and_a_halt_are_runtime_errors_that_name_the_place) {
  IsaContext illegal(Code{encode("nop", {0}), 0x01400000});
  EXPECT_EQ(illegal.run(), -1);
  EXPECT_EQ(errno, EFAULT);
  EXPECT_EQ(illegal.stop.stop_reason, unsigned{SPE_RUNTIME_ERROR});
  EXPECT_EQ(illegal.stop.result.spe_runtime_error, SPE_SPU_INVALID_INSTR);
  illegal.expect_fault("0x01400000 encodes no instruction");
  illegal.expect_fault("pc 0x00084 in begin+0x4");
  EXPECT_EQ(illegal.resume(), -1);
  IsaContext halt(Code{encode("heqi", {0, 0, 0})});
  EXPECT_EQ(halt.run(), -1);
  EXPECT_EQ(halt.stop.result.spe_runtime_error, SPE_SPU_HALT);
  halt.expect_fault("heqi");
  EXPECT_NE(registers(halt.spe).find("r127"), std::string::npos);
}

TEST(IsaProgram, a_wild_branch_ends_in_a_stop_of_zeros) {
  IsaContext context(Code{encode("bra", {0x20000})});
  EXPECT_EQ(context.run(), 0);
  EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_STOP_AND_SIGNAL});
  EXPECT_EQ(context.stop.result.spe_signal_code, 0);
  EXPECT_NE(where(context.spe).find("pc 0x20000"), std::string::npos) << where(context.spe);
}

/// An address without memory: far from what the system maps, and no part of a sanitizer's shadow.
void* unmapped_page() {
  return reinterpret_cast<void*>(std::uintptr_t{1} << 46U);
}

/// Not before Linux 5.14, and not through an emulator of user processes.
bool system_tells_what_may_be_accessed() {
  return madvise(nullptr, 4096, MADV_POPULATE_READ) != 0 && errno == ENOMEM;
}

/// A big-endian machine moves parts of words as a Cell does.
constexpr bool kOnlyWordsMove = kSpuWordOrder == WordOrder::swapped;

struct BadDma {
  const char* name;
  std::int32_t ls;
  std::int32_t size;
  std::uintptr_t ea;
  int exception;
  bool found = true;
};

TEST(IsaProgram, bad_dma_is_an_exception_and_never_the_end_of_the_process) {
  void* forbidden = mmap(nullptr, 4096, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  void* constant = mmap(nullptr, 4096, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(forbidden, MAP_FAILED);
  MainWords memory;
  const auto good = reinterpret_cast<std::uintptr_t>(&memory);
  const bool told = system_tells_what_may_be_accessed();
  const BadDma cases[] = {
      {"misaligned", 0x1004, 16, good, SPE_DMA_ALIGNMENT},
      {"beyond the local store", 0x3fff0, 32, good, SPE_INVALID_DMA},
      {"half a word", 0x1000, 2, good, SPE_INVALID_DMA, kOnlyWordsMove},
      {"null", 0x1000, 16, 0, SPE_DMA_STORAGE},
      {"not mapped", 0x1000, 16, reinterpret_cast<std::uintptr_t>(unmapped_page()), SPE_DMA_STORAGE},
      {"forbidden", 0x1000, 16, reinterpret_cast<std::uintptr_t>(forbidden), SPE_DMA_STORAGE, told},
      {"constant", 0x1000, 16, reinterpret_cast<std::uintptr_t>(constant), SPE_DMA_STORAGE, told},
  };
  for (const BadDma& bad : cases) {
    if (!bad.found) continue;
    Code code;
    append_wait(append_dma(code, MFC_PUT_CMD, bad.ls, bad.size));
    code.push_back(kExit);
    IsaContext context(code);
    EXPECT_EQ(context.run(reinterpret_cast<void*>(bad.ea)), -1) << bad.name;
    EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_RUNTIME_EXCEPTION}) << bad.name;
    EXPECT_EQ(context.stop.result.spe_runtime_exception, bad.exception)
        << bad.name << last_fault(context.spe);
    context.expect_fault("wrch");
  }
  munmap(forbidden, 4096);
  munmap(constant, 4096);
}

TEST(IsaProgram, atomics_on_addresses_without_memory_are_exceptions) {
  Code code;
  append_dma(code, MFC_GETLLAR_CMD, 0x1000, 128);
  code.push_back(kExit);
  IsaContext context(code);
  EXPECT_EQ(context.run(unmapped_page()), -1);
  EXPECT_EQ(context.stop.result.spe_runtime_exception, SPE_DMA_STORAGE);
}

TEST(IsaProgram, unchecked_mode_still_refuses_parts_of_words) {
  if (!kOnlyWordsMove) GTEST_SKIP() << "they move on a big-endian machine";
  EmulationSettings settings;
  settings.dma_mode = DmaMode::unchecked;
  Code code;
  append_dma(code, MFC_GET_CMD, 0x3fffc, 1);
  code.push_back(kExit);
  IsaContext context(code, settings);
  const MainWords memory;
  EXPECT_EQ(context.run(&memory), -1);
  context.expect_fault("whole words");
}

TEST(IsaProgram, an_endless_loop_ends_at_the_instruction_limit) {
  EmulationSettings settings;
  settings.instruction_limit = 12345;
  IsaContext context(Code{encode("br", {0})}, settings);
  EXPECT_EQ(context.run(), -1);
  EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_RUNTIME_FATAL});
  EXPECT_EQ(context.stop.result.spe_runtime_fatal, ETIMEDOUT);
  EXPECT_EQ(statistics(context.spe).instructions, 12345U);
  EXPECT_EQ(context.run(), -1) << "each start has the whole limit";
  EXPECT_EQ(statistics(context.spe).instructions, 12345U);
}

TEST(IsaProgram, a_loop_and_a_wait_without_an_end_end_at_the_time_limit) {
  EmulationSettings settings;
  settings.time_limit = std::chrono::milliseconds(20);
  for (const std::uint32_t word : {encode("br", {0}), encode("rdch", {20, 29})}) {
    IsaContext context(Code{word}, settings);
    for (int start = 0; start < 2; ++start) {
      EXPECT_EQ(context.run(), -1);
      EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_RUNTIME_FATAL});
      EXPECT_EQ(context.stop.result.spe_runtime_fatal, ETIMEDOUT);
      context.expect_fault("rule \"time limit\": SPE ");
    }
  }
}

TEST(IsaProgram, a_time_limit_leaves_the_instruction_limit_exact) {
  EmulationSettings settings;
  settings.time_limit = std::chrono::hours(1);
  settings.instruction_limit = 1234567;
  IsaContext context(Code{encode("br", {0})}, settings);
  EXPECT_EQ(context.run(), -1);
  context.expect_fault("instruction limit");
  EXPECT_EQ(statistics(context.spe).instructions, 1234567U);
}

TEST(IsaProgram, a_program_that_does_not_fit_the_limit_is_refused_with_numbers) {
  EmulationSettings settings;
  settings.local_store_limit = 64 * 1024;
  const auto file = [](std::uint32_t size) {
    return ElfBuilder(0x80, {{0x80, {stop_with(0x2000)}, size - 0x80}}).build();
  };
  IsaContext fits(file(48 * 1024), settings);
  EXPECT_EQ(fits.load_result, 0);
  EXPECT_EQ(spe_ls_size_get(fits.spe), 64 * 1024);
  IsaContext too_large(file(48 * 1024 + 16), settings);
  EXPECT_EQ(too_large.load_result, -1);
  too_large.expect_fault("49168 bytes and 16384 of stack");
  settings.local_store_limit = 0;
  IsaContext full(file(256 * 1024), settings);
  EXPECT_EQ(full.load_result, 0) << "without a limit it gets what the hardware has";
  EXPECT_EQ(spe_ls_size_get(full.spe), 256 * 1024);
}

TEST(IsaProgram, below_256_KB_the_stack_moves_down_and_stores_beyond_are_found) {
  EmulationSettings settings;
  settings.local_store_limit = 128 * 1024;
  IsaContext stack(Code{encode("ila", {1, 0x3fff0}), encode("stqd", {1, 0, 1}), kExit}, settings);
  EXPECT_EQ(stack.run(), 0) << last_fault(stack.spe);
  EXPECT_EQ(stack.word(0x1fff0), 0x1fff0U);
  IsaContext wild(Code{encode("ila", {20, 0x30000}), encode("stqd", {20, 0, 20}), kExit}, settings);
  EXPECT_EQ(wild.run(), -1);
  EXPECT_EQ(wild.stop.stop_reason, unsigned{SPE_RUNTIME_FATAL});
  wild.expect_fault("beyond the limit of 131072");
  Code code;
  append_dma(code, MFC_GET_CMD, 0x20000, 16);
  code.push_back(kExit);
  IsaContext dma(code, settings);
  const MainWords memory;
  EXPECT_EQ(dma.run(&memory), -1);
  dma.expect_fault("local store of 131072");
}

TEST(IsaProgram, without_events_enabled_bad_dma_is_sigbus) {
#if defined(__x86_64__)  // The program would start itself again, which an emulator's cannot.
  GTEST_FLAG_SET(death_test_style, "threadsafe");
#endif
  EXPECT_EXIT(
      {
        Code code;
        append_dma(code, MFC_GET_CMD, 0x1004, 16);
        IsaContext context(code, {}, 0);
        std::signal(SIGBUS, SIG_DFL);
        context.run();
      },
      testing::KilledBySignal(SIGBUS), "16-byte alignment");
}

TEST(IsaProgram, an_overlay_program_finds_its_file_in_main_memory) {
  Code code{encode("lqa", {4, 0x400})};
  append_wait(append_dma(code, MFC_GET_CMD, 0x1000, 16));
  code.push_back(kExit);
  File file = ElfBuilder(0x80, {{0x80, code}, {0x400, {0, 0, 0, 0}}}, {{"_EAR_", 0x400}}).build();
  const std::uint32_t first_word = read_word(file.data());
  IsaContext context(std::move(file));
  EXPECT_EQ(context.run(), 0) << last_fault(context.spe);
  EXPECT_EQ(context.word(0x1000), first_word);
}

/// A program that has two quadwords of .toe at 0x400 and exits.
File program_with_toe() {
  return ElfBuilder(0x80, {{0x80, {kExit}}, {0x400, {0, 0, 0, 0, 0, 0, 0, 0}}}, {{"begin", 0x80}})
      .with_toe(0x400, 32)
      .build();
}

TEST(IsaProgram, effective_addresses_of_the_handle_come_into_the_section_toe) {
  IsaContext context(Code{kExit});
  File file = program_with_toe();
  const std::uint64_t shadow[] = {0x123456789abcdef0, 5, 0x42, 7};
  spe_program_handle_t handle{sizeof handle, file.data(), const_cast<std::uint64_t*>(shadow)};
  ASSERT_EQ(spe_program_load(context.spe, &handle), 0) << last_fault(context.spe);
  EXPECT_EQ(context.word(0x400), 0x12345678U);
  EXPECT_EQ(context.word(0x404), 0x9abcdef0U);
  EXPECT_EQ(context.word(0x408), 0U);
  EXPECT_EQ(context.word(0x410), 0U);
  EXPECT_EQ(context.word(0x414), 0x42U);
  EXPECT_EQ(context.run(), 0);
}

TEST(IsaProgram, a_handle_that_is_too_small_for_effective_addresses_has_none) {
  IsaContext context(Code{kExit});
  File file = program_with_toe();
  spe_program_handle_t handle{sizeof handle - sizeof(void*), file.data(), file.data()};
  ASSERT_EQ(spe_program_load(context.spe, &handle), 0);
  EXPECT_EQ(context.word(0x400), 0U);
}

TEST(IsaProgram, effective_addresses_that_cannot_be_read_are_refused) {
  IsaContext context(Code{kExit});
  File file = program_with_toe();
  spe_program_handle_t handle{sizeof handle, file.data(), reinterpret_cast<void*>(0x1000)};
  EXPECT_EQ(spe_program_load(context.spe, &handle), -1);
  EXPECT_EQ(errno, EINVAL);
  context.expect_fault("broken handle: the 32 bytes of toe_shadow at 0x1000");
}

TEST(IsaProgram, a_section_toe_outside_of_the_local_store_counts_for_nothing) {
  IsaContext context(Code{kExit});
  File file = ElfBuilder(0x80, {{0x80, {kExit}}}, {{"begin", 0x80}}).with_toe(0x3fff0, 32).build();
  spe_program_handle_t handle{sizeof handle, file.data(), file.data()};
  EXPECT_EQ(spe_program_load(context.spe, &handle), 0);
  EXPECT_EQ(context.run(), 0);
}

TEST(IsaProgram, either_kind_of_program_may_follow_the_other_in_a_context) {
  IsaContext context(Code{kExit});
  std::vector<std::byte> broken(256);
  spe_program_handle_t handle{sizeof handle, broken.data(), nullptr};
  EXPECT_EQ(spe_program_load(context.spe, &handle), -1);
  EXPECT_EQ(context.run(), -1);
  EXPECT_EQ(errno, EINVAL);
  File file = ElfBuilder(0, {{0, {stop_with(0x2009)}}}).build();
  handle.elf_image = file.data();
  EXPECT_EQ(spe_program_load(context.spe, &handle), 0);
  EXPECT_EQ(context.run(), 0);
  EXPECT_EQ(context.stop.result.spe_exit_code, 9);
}

}  // namespace
}  // namespace spu_emu::isa
