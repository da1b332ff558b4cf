// An SPU program that does what ends programs of this machine, one way after another.
#include <spu_mfcio.h>

#include <climits>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "rogue.h"

// An assertion that holds in every build.
#undef NDEBUG
#include <cassert>

namespace {

// The compiler must not see what they are.
volatile int zero = 0;
volatile int lowest = INT_MIN;
volatile int minus_one = -1;
char* volatile nowhere = nullptr;

alignas(128) unsigned int words[32];

__attribute__((noinline)) int recurse(int depth) {
  volatile char some[256];
  some[depth % 256] = 1;
  return recurse(depth + 1) + some[(depth + 1) % 256];
}

__attribute__((noinline)) int recurse_with_dma(int depth, unsigned long long ea) {
  volatile char some[256];
  some[depth % 256] = 1;
  mfc_get(words, ea, 128, 3, 0, 0);
  mfc_write_tag_mask(1U << 3);
  mfc_read_tag_status_all();
  return recurse_with_dma(depth + 1, ea) + some[(depth + 1) % 256];
}

/// Goes on until memory ends.
void overrun_the_heap() {
  auto* block = static_cast<volatile char*>(std::malloc(100));
  for (unsigned int i = 0;; ++i) block[i] = 1;
}

/// As a loop over whole vectors may, which the 4 bytes behind 28 would not mind.
volatile char* overrun_a_block(unsigned int bytes) {
  auto* block = static_cast<volatile char*>(std::malloc(28));
  for (unsigned int i = 0; i < bytes; ++i) block[i] = 1;
  return block;
}

void overrun_a_block_by_dma(unsigned long long ea) {
  auto* block = static_cast<char*>(std::malloc(112));
  mfc_get(block, ea, 128, 3, 0, 0);
  mfc_write_tag_mask(1U << 3);
  mfc_read_tag_status_all();
}

void write_beyond_the_store() {
  auto* block = static_cast<char*>(std::malloc(16));
  const unsigned int ls = static_cast<unsigned int>(reinterpret_cast<unsigned long long>(block));
  *static_cast<volatile char*>(block - ls + 256 * 1024 + 16) = 1;
}

__attribute__((noinline)) void throw_error(const char* what) {
  if (zero == 0) throw std::runtime_error(what);
}

void throw_out_of_noexcept() noexcept {
  throw_error("not out of here");
}

int fault_inside_a_handler() {
  try {
    throw 5;
  } catch (int value) {
    *static_cast<volatile char*>(nowhere) = static_cast<char>(value);
    return value;
  }
}

[[noreturn]] void loop() {
  for (volatile unsigned int i = 0;;) i = i + 1;
}

[[noreturn]] void loop_over_the_c_library() {
  static char text[1000];
  for (;;) std::memset(text, zero, sizeof text - static_cast<unsigned>(zero));
}

void wait_for_an_event() {
  spu_write_event_mask(MFC_SIGNAL_NOTIFY_1_EVENT);
  spu_read_event_status();
}

}  // namespace

int main(unsigned long long, unsigned long long argp, unsigned long long envp) {
  switch (static_cast<Rogue>(argp)) {
    case Rogue::nothing:
      return static_cast<int>(envp);
    case Rogue::write_to_null:
      *static_cast<volatile char*>(nowhere) = 1;
      return 1;
    case Rogue::write_beyond_the_store:
      write_beyond_the_store();
      return 1;
    case Rogue::overrun_the_heap:
      overrun_the_heap();
      return 1;
    case Rogue::overrun_a_block:
      overrun_a_block(envp == 0 ? 33 : 32);
      return static_cast<int>(envp);
    case Rogue::overrun_a_freed_block:
      std::free(const_cast<char*>(overrun_a_block(40)));
      loop();
    case Rogue::overrun_a_block_by_dma:
      overrun_a_block_by_dma(envp);
      return 1;
    case Rogue::jump_to_null:
      reinterpret_cast<void (*)()>(nowhere)();
      return 1;
    case Rogue::run_into_no_instruction:
      __builtin_trap();
    case Rogue::recurse:
      return recurse(0);
    case Rogue::recurse_with_dma:
      return recurse_with_dma(0, envp);
    case Rogue::divide_by_zero:
      return lowest / zero;
    case Rogue::divide_lowest_by_minus_one:
      return lowest / minus_one;
    case Rogue::abort:
      std::abort();
    case Rogue::fail_assertion:
      assert(zero != 0 && "a rogue keeps its word");
      return 1;
    case Rogue::throw_exception:
      throw_error("forgotten by the program");
      return 1;
    case Rogue::throw_number:
      throw 5;
    case Rogue::throw_out_of_noexcept:
      throw_out_of_noexcept();
      return 1;
    case Rogue::fault_inside_a_handler:
      return fault_inside_a_handler();
    case Rogue::copy_to_null:
      std::memcpy(nowhere, words, sizeof words - static_cast<unsigned>(zero));
      return 1;
    case Rogue::loop:
      loop();
    case Rogue::loop_over_the_c_library:
      loop_over_the_c_library();
    case Rogue::wait_for_a_mailbox:
      return static_cast<int>(spu_read_in_mbox());
    case Rogue::wait_for_an_event:
      wait_for_an_event();
      return 1;
  }
  return 99;
}
