// Library calls of SPU programs: results and errno, files and who may have them, calls with wrong arguments.
#include "isa/libc/library_calls.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>

#include "../isa_context.h"
#include "call_store.h"

namespace spu_emu::isa {
namespace {

enum Stdio : unsigned {
  kFclose = 2,
  kFgets = 8,
  kFileno = 9,
  kFopen = 10,
  kFread = 13,
  kFreopen = 14,
  kFseek = 15,
  kFtell = 17,
  kFwrite = 18,
  kPuts = 25,
  kRemove = 26,
  kSystem = 31,
  kVprintf = 37,
  kVsnprintf = 39
};
enum Posix : unsigned {
  kClose = 2,
  kFstat = 4,
  kTime = 7,
  kLseek = 9,
  kOpen = 15,
  kRead = 16,
  kUnlink = 24,
  kWrite = 27
};

std::string scratch_file() {
  return testing::TempDir() + "spu_emu_calls_" + std::to_string(getpid());
}

TEST(LibraryCalls, print_to_standard_output_and_give_the_count) {
  CallStore f;
  f.add_word(42);
  testing::internal::CaptureStdout();
  EXPECT_EQ(f.stdio(kVprintf, {f.text("n = %d\n"), CallStore::kArguments, CallStore::kArgumentsEnd}), 7U);
  f.stdio(kPuts, {f.text("line")});
  std::fflush(stdout);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "n = 42\nline\n");
  EXPECT_EQ(f.error, 0U);
}

TEST(LibraryCalls, snprintf_cuts_and_tells_the_whole_length) {
  CallStore f;
  EXPECT_EQ(
      f.stdio(kVsnprintf, {0x700, 4, f.text("abcdef"), CallStore::kArguments, CallStore::kArgumentsEnd}), 6U);
  EXPECT_EQ(f.store.text(0x700), "abc");
}

TEST(LibraryCalls, streams_write_seek_and_read_files) {
  CallStore f;
  const std::uint32_t name = f.text(scratch_file());
  const std::uint32_t stream = f.stdio(kFopen, {name, f.text("w+")});
  ASSERT_GE(stream, 4U);
  EXPECT_EQ(f.stdio(kFwrite, {f.text("one\ntwo\n"), 4, 2, stream}), 2U);
  EXPECT_EQ(f.stdio(kFtell, {stream}), 8U);
  EXPECT_EQ(f.stdio(kFseek, {stream, 0, 0}), 0U);
  EXPECT_EQ(f.stdio(kFgets, {0x700, 100, stream}), 0x700U);
  EXPECT_EQ(f.store.text(0x700), "one\n");
  EXPECT_EQ(f.stdio(kFread, {0x800, 1, 100, stream}), 4U);
  EXPECT_EQ(f.stdio(kFclose, {stream}), 0U);
  EXPECT_EQ(f.stdio(kFclose, {stream}), UINT32_MAX);
  EXPECT_EQ(f.error, unsigned{EBADF});
  EXPECT_EQ(f.stdio(kRemove, {name}), 0U);
  EXPECT_FALSE(std::filesystem::exists(scratch_file()));
}

TEST(LibraryCalls, freopen_redirects_the_programs_output_and_not_ours) {
  const std::string name = scratch_file();
  {
    CallStore f;
    EXPECT_EQ(f.stdio(kFreopen, {f.text(name), f.text("w"), 2}), 2U);
    f.stdio(kPuts, {f.text("elsewhere")});
    EXPECT_EQ(f.stdio(kFreopen, {f.text(name), f.text("w"), 99}), 0U);
    EXPECT_EQ(f.error, unsigned{EBADF});
  }
  EXPECT_EQ(std::filesystem::file_size(name), 10U);
  std::filesystem::remove(name);
}

TEST(LibraryCalls, a_line_longer_than_the_store_is_cut_at_its_size) {
  CallStore f;
  const std::uint32_t zeros = f.stdio(kFopen, {f.text("/dev/zero"), f.text("r")});
  EXPECT_EQ(f.stdio(kFgets, {0x700, UINT32_MAX, zeros}), UINT32_MAX);
  EXPECT_EQ(f.error, unsigned{EFAULT}) << "it does not fit behind 0x700";
}

TEST(LibraryCalls, descriptors_open_write_and_read_files) {
  CallStore f;
  const std::uint32_t name = f.text(scratch_file());
  const std::uint32_t file = f.posix(kOpen, {name, 02 | 0100 | 01000, 0600});
  ASSERT_NE(file, UINT32_MAX) << f.error;
  EXPECT_EQ(f.posix(kWrite, {file, f.text("bytes"), 5}), 5U);
  EXPECT_EQ(f.posix(kLseek, {file, 1, 0}), 1U);
  EXPECT_EQ(f.posix(kRead, {file, 0x700, 100}), 4U);
  EXPECT_EQ(f.store.text(0x700), "ytes");
  EXPECT_EQ(f.posix(kFstat, {file, 0x800}), 0U);
  EXPECT_EQ(f.store.word(0x800 + 7 * 4), 5U) << "the eighth word is the size";
  EXPECT_EQ(f.posix(kClose, {file}), 0U);
  EXPECT_EQ(f.posix(kUnlink, {name}), 0U);
  EXPECT_EQ(f.posix(kOpen, {name, 0, 0}), UINT32_MAX);
  EXPECT_EQ(f.error, unsigned{ENOENT});
}

TEST(LibraryCalls, time_has_seconds_of_64_bits) {
  CallStore f;
  EXPECT_EQ(f.posix(kTime, {0x700, 0}), 0U);
  EXPECT_NEAR(static_cast<double>(f.store.doubleword(0x700)), static_cast<double>(std::time(nullptr)), 2.0);
}

TEST(LibraryCalls, the_programs_reach_no_descriptor_of_this_process_but_the_standard_ones) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  CallStore f;
  for (const int foreign : {ends[0], ends[1], -1, 9999}) {
    EXPECT_EQ(f.posix(kWrite, {static_cast<std::uint32_t>(foreign), 0x700, 1}), UINT32_MAX);
    EXPECT_EQ(f.error, unsigned{EBADF});
    EXPECT_EQ(f.posix(kClose, {static_cast<std::uint32_t>(foreign)}), UINT32_MAX);
  }
  EXPECT_EQ(f.posix(kClose, {2}), 0U);
  EXPECT_EQ(write(2, "", 0), 0) << "the standard streams stay open";
  EXPECT_EQ(close(ends[0]), 0);
  EXPECT_EQ(close(ends[1]), 0);
}

TEST(LibraryCalls, without_files_the_console_still_works) {
  CallStore f(LibraryCallAccess::console);
  const std::uint32_t name = f.text("/dev/null");
  EXPECT_EQ(f.stdio(kFopen, {name, f.text("r")}), 0U);
  EXPECT_EQ(f.error, unsigned{EACCES});
  EXPECT_EQ(f.posix(kOpen, {name, 0, 0}), UINT32_MAX);
  EXPECT_EQ(f.error, unsigned{EACCES});
  testing::internal::CaptureStdout();
  f.stdio(kPuts, {f.text("seen")});
  std::fflush(stdout);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "seen\n");
}

TEST(LibraryCalls, switched_off_every_call_fails_with_enosys) {
  CallStore f(LibraryCallAccess::none);
  testing::internal::CaptureStdout();
  EXPECT_EQ(f.stdio(kPuts, {f.text("unseen")}), UINT32_MAX);
  EXPECT_EQ(f.error, unsigned{ENOSYS});
  std::fflush(stdout);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

TEST(LibraryCalls, unknown_calls_fail_with_enosys_and_wrong_addresses_with_efault) {
  CallStore f;
  for (const unsigned number : {0U, unsigned{kSystem}, 42U, 255U}) {
    EXPECT_EQ(f.stdio(number, {0x700}), UINT32_MAX);
    EXPECT_EQ(f.error, unsigned{ENOSYS});
  }
  EXPECT_EQ(f.posix(200, {0x700}), UINT32_MAX);
  EXPECT_EQ(f.error, unsigned{ENOSYS});
  for (const std::uint32_t wild : {0x40000U, 0x3ffffffU, 0xffffffffU}) {
    EXPECT_EQ(f.stdio(kPuts, {wild}), UINT32_MAX);
    EXPECT_EQ(f.error, unsigned{EFAULT});
    EXPECT_EQ(f.posix(kWrite, {1, wild, 16}), UINT32_MAX);
    EXPECT_EQ(f.error, unsigned{EFAULT});
    EXPECT_EQ(f.posix(kRead, {0, 0x3fff0, wild}), UINT32_MAX);
    EXPECT_EQ(f.error, unsigned{EFAULT});
    EXPECT_EQ(f.stdio(kFwrite, {0x700, wild, wild, 2}), UINT32_MAX);
    EXPECT_EQ(f.error, unsigned{EFAULT});
  }
}

TEST(LibraryCalls, an_argument_block_outside_the_store_or_an_unknown_code_is_a_failed_call) {
  CallStore f;
  f.store.set_word(0x100, 0x19fffff0);
  EXPECT_FALSE(f.calls.serve(0x2100, 0x100));
  EXPECT_FALSE(f.calls.serve(0x2100, 0x40000));
  EXPECT_FALSE(f.calls.serve(0x2110, 0x100));
}

TEST(LibraryCalls, system_calls_of_linux_give_the_process_and_else_enosys) {
  CallStore f;
  f.store.set_word(0x100, 0x600);
  f.store.set_doubleword(0x600, 20);
  EXPECT_TRUE(f.calls.serve(0x2104, 0x100));
  EXPECT_EQ(f.store.doubleword(0x600), static_cast<std::uint64_t>(getpid()));
  f.store.set_doubleword(0x600, 11);
  EXPECT_TRUE(f.calls.serve(0x2104, 0x100));
  EXPECT_EQ(f.store.doubleword(0x600), static_cast<std::uint64_t>(-ENOSYS));
}

/// Calls puts through a stop, then exits with what came back in the block's first word.
Code program_that_puts() {
  return {stop_with(0x2100), 0x19000000U | 0x200, encode("lqa", {20, 0x200}), encode("stqa", {20, 0x300}),
          stop_with(0x2000)};
}

File file_that_puts() {
  return ElfBuilder(0x80, {{0x80, program_that_puts()}, {0x200, {0x210, 0, 0, 0, 0x68690000}}}).build();
}

TEST(LibraryCalls, are_served_in_a_run_and_the_program_goes_on_behind_their_word) {
  IsaContext context(file_that_puts());
  testing::internal::CaptureStdout();
  EXPECT_EQ(context.run(), 0) << last_fault(context.spe);
  std::fflush(stdout);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "hi\n");
  EXPECT_EQ(context.word(0x300), 3U);
}

TEST(LibraryCalls, without_callbacks_the_stop_is_the_hosts) {
  IsaContext context(file_that_puts());
  EXPECT_EQ(context.run(nullptr, SPE_NO_CALLBACKS), 0x2100);
  EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_STOP_AND_SIGNAL});
  EXPECT_EQ(context.word(context.entry), 0x19000200U);
  context.entry += 4;
  EXPECT_EQ(context.resume(SPE_NO_CALLBACKS), 0);
  EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_EXIT});
}

std::uint32_t seen_word = 0;
int remember_word(void* ls_base, unsigned int address) {
  seen_word = read_word(static_cast<std::byte*>(ls_base) + address);
  return 0;
}

TEST(LibraryCalls, a_registered_handler_takes_the_place_of_ours) {
  void* ours = spe_callback_handler_query(0);
  ASSERT_EQ(spe_callback_handler_register(reinterpret_cast<void*>(&remember_word), 0, SPE_CALLBACK_UPDATE),
            0);
  IsaContext context(file_that_puts());
  EXPECT_EQ(context.run(), 0) << last_fault(context.spe);
  EXPECT_EQ(seen_word, 0x19000200U);
  EXPECT_EQ(spe_callback_handler_register(ours, 0, SPE_CALLBACK_UPDATE), 0);
}

TEST(LibraryCalls, a_code_that_nobody_serves_is_a_callback_error) {
  IsaContext context(Code{stop_with(0x2177), 0});
  EXPECT_EQ(context.run(), -1);
  EXPECT_EQ(errno, EFAULT);
  EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_CALLBACK_ERROR});
}

}  // namespace
}  // namespace spu_emu::isa
