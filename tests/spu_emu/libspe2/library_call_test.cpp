// Library calls 0x21xx: handlers of the host, called in the middle of an SPU program.
#include <cstring>

#include "../host/test_context.h"

namespace spu_emu {
namespace {

/// Adds the first two words of the argument block into the third; the block's address is in the call's word.
int add_words(void* ls_base, unsigned int word_address) {
  auto* base = static_cast<unsigned char*>(ls_base);
  unsigned int word = 0;
  std::memcpy(&word, base + word_address, sizeof word);
  if (word >> 24U != 5) return 3;
  auto* block = reinterpret_cast<unsigned int*>(base + (word & 0xffffffU));
  block[2] = block[0] + block[1];
  return 0;
}

int refuse(void*, unsigned int) {
  return 7;
}
int accept(void*, unsigned int) {
  return 0;
}

struct Registered {
  explicit Registered(int (*handler)(void*, unsigned int)) {
    EXPECT_EQ(spe_callback_handler_register(reinterpret_cast<void*>(handler), 0x10, SPE_CALLBACK_NEW), 0);
  }
  ~Registered() { spe_callback_handler_deregister(0x10); }
  Registered(const Registered&) = delete;
  Registered& operator=(const Registered&) = delete;
};

TEST(LibraryCall, the_handler_reads_and_writes_the_programs_arguments) {
  const Registered handler(&add_words);
  TestContext context;
  EXPECT_EQ(context.exit_code(Probe::library_call), 42);
}

TEST(LibraryCall, a_plain_stop_with_the_code_calls_the_handler_and_goes_on) {
  const Registered handler(&accept);
  TestContext context;
  EXPECT_EQ(context.exit_code(Probe::plain_library_stop), 9);
}

TEST(LibraryCall, a_handler_that_fails_ends_the_run) {
  const Registered handler(&refuse);
  TestContext context;
  EXPECT_EQ(context.run(Probe::plain_library_stop), -1);
  EXPECT_EQ(errno, EFAULT);
  EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_CALLBACK_ERROR});
  EXPECT_EQ(context.stop.result.spe_callback_error, 7);
}

TEST(LibraryCall, without_a_handler_the_run_fails) {
  TestContext context;
  EXPECT_EQ(context.run(Probe::plain_library_stop), -1);
  EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_CALLBACK_ERROR});
}

TEST(LibraryCall, no_callbacks_makes_it_a_stop_and_signal) {
  TestContext context;
  EXPECT_EQ(context.run(Probe::plain_library_stop, 0, SPE_NO_CALLBACKS), 0x2110);
  EXPECT_EQ(context.stop.stop_reason, unsigned{SPE_STOP_AND_SIGNAL});
  EXPECT_EQ(context.resume(), 0);
  EXPECT_EQ(context.stop.result.spe_exit_code, 9);
}

TEST(LibraryCall, registration_follows_the_librarys_rules) {
  auto* handler = reinterpret_cast<void*>(&accept);
  const auto fails_with = [](int error, int result) {
    return result == -1 && std::exchange(errno, 0) == error;
  };
  EXPECT_TRUE(fails_with(EINVAL, spe_callback_handler_register(handler, 256, SPE_CALLBACK_NEW)));
  EXPECT_TRUE(fails_with(EINVAL, spe_callback_handler_register(handler, 0x10, 9)));
  EXPECT_TRUE(fails_with(EACCES, spe_callback_handler_register(handler, 0, SPE_CALLBACK_NEW)));
  EXPECT_TRUE(fails_with(ESRCH, spe_callback_handler_register(handler, 0x10, SPE_CALLBACK_UPDATE)));
  EXPECT_TRUE(fails_with(EINVAL, spe_callback_handler_register(nullptr, 0x10, SPE_CALLBACK_NEW)));
  EXPECT_EQ(spe_callback_handler_register(handler, 0x10, SPE_CALLBACK_NEW), 0);
  EXPECT_TRUE(fails_with(EACCES, spe_callback_handler_register(handler, 0x10, SPE_CALLBACK_NEW)));
  EXPECT_EQ(spe_callback_handler_query(0x10), handler);
  EXPECT_EQ(spe_callback_handler_register(reinterpret_cast<void*>(&refuse), 0x10, SPE_CALLBACK_UPDATE), 0);
  EXPECT_EQ(spe_callback_handler_deregister(0x10), 0);
  EXPECT_TRUE(fails_with(ESRCH, spe_callback_handler_deregister(0x10)));
  EXPECT_TRUE(fails_with(EACCES, spe_callback_handler_deregister(1)));
  EXPECT_TRUE(fails_with(EINVAL, spe_callback_handler_deregister(999)));
  EXPECT_EQ(spe_callback_handler_query(0x10), nullptr);
  EXPECT_EQ(errno, ESRCH);
}

}  // namespace
}  // namespace spu_emu
