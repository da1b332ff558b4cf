// The SPU program of the host engine's tests: does one small thing after another, as its arguments say.
#include <free_align.h>
#include <malloc_align.h>
#include <spu_mfcio.h>
#include <xmmintrin.h>

#include <cstdlib>
#include <cstring>
#include <list>

#include "probe.h"

extern "C" int __send_to_ppe(unsigned int code, unsigned int opcode, void* data);

namespace {

constexpr unsigned int kTag = 3;
constexpr unsigned int kWords = 64;

int runs = 0;
alignas(128) unsigned int global_words[kWords];
alignas(128) const unsigned int kConstant[4] = {0x11111111, 0x22222222, 0x33333333, 0x44444444};

/// Shows that constructors run before main and destructors at exit: its last word goes to the out mailbox.
struct Lifetime {
  Lifetime() : word(0x600d) {}
  ~Lifetime() {
    if (spu_stat_out_mbox() != 0) spu_write_out_mbox(word);
  }
  unsigned int word;
} lifetime;

void wait() {
  mfc_write_tag_mask(1U << kTag);
  mfc_read_tag_status_all();
}

int sum(unsigned int* words, unsigned long long ea) {
  mfc_get(words, ea, kWords * sizeof(unsigned int), kTag, 0, 0);
  wait();
  unsigned int total = 0;
  for (unsigned int i = 0; i < kWords; ++i) total += words[i];
  return static_cast<int>(total & 0xffU);
}

/// The host fills the global by its LS address, which is sent as programs send it, in one word.
int send_global_and_wait() {
  spu_write_out_mbox(static_cast<unsigned int>(reinterpret_cast<std::uintptr_t>(&global_words[0])));
  spu_read_in_mbox();
  for (unsigned int& word : global_words) ++word;
  return static_cast<int>(global_words[5]);
}

int sum_into_heap(unsigned long long ea) {
  auto* words = static_cast<unsigned int*>(_malloc_align(kWords * sizeof(unsigned int), 7));
  const int total = sum(words, ea);
  _free_align(words);
  return total;
}

__attribute__((noinline)) void get_to_deep_stack(unsigned long long ea) {
  alignas(128) volatile char deep[40000];
  mfc_get(deep, ea, 128, kTag, 0, 0);
  wait();
}

int stop_inside_a_handler() {
  try {
    throw 5;
  } catch (int value) {
    spu_stop(0x77);
    try {
      throw 6;
    } catch (int inner) {
      return value * 10 + inner;
    }
  }
}

int allocate_until_full(unsigned long long size) {
  for (;;) *static_cast<volatile char*>(std::malloc(size)) = 1;
}

int use_the_heap() {
  std::list<int> numbers;
  for (int i = 0; i < 100; ++i) numbers.push_back(i);
  auto* zeroes = static_cast<int*>(std::calloc(10, sizeof(int)));
  auto* grown = static_cast<int*>(std::realloc(zeroes, 400));
  const bool right = numbers.back() == 99 && grown[9] == 0 && mfc_ceil128(129) == 256 &&
                     reinterpret_cast<unsigned long long>(_malloc_align(1, 7)) % 128 == 0;
  std::free(grown);
  char* text = strdup("from the C library");
  std::free(text);
  return right ? 0 : 1;
}

void free_twice() {
  void* volatile block = std::malloc(16);
  std::free(block);
  std::free(block);
}

int library_call() {
  auto* words = static_cast<unsigned int*>(std::malloc(16));
  words[0] = 20;
  words[1] = 22;
  __send_to_ppe(0x2110, 5, words);
  return static_cast<int>(words[2]);
}

int echo_mailbox() {
  for (;;) {
    const unsigned int message = spu_read_in_mbox();
    if (message == 0) return 0;
    if ((message & 1U) != 0) {
      spu_write_out_mbox(message + 1);
    } else {
      spu_write_out_intr_mbox(message + 1);
    }
  }
}

int read_without_waiting(unsigned long long ea) {
  auto* words = static_cast<unsigned int*>(_malloc_align(128, 7));
  mfc_get(words, ea, 128, kTag, 0, 0);
  const unsigned int early = *static_cast<volatile unsigned int*>(words);
  wait();
  return early == words[0] ? 1 : 0;
}

/// The store is one that AddressSanitizer does not see, so that it is found when the get lands.
__attribute__((no_sanitize("address"))) void touch(volatile unsigned int* word) {
  *word = 5;
}

void write_without_waiting(unsigned long long ea) {
  mfc_get(global_words, ea, sizeof global_words, kTag, 0, 0);
  touch(global_words + 7);
  wait();
}

int list_on_stack(unsigned long long ea) {
  alignas(8) mfc_list_element_t list[2] = {{0, 0, 128, mfc_ea2l(ea)}, {0, 0, 128, mfc_ea2l(ea) + 128}};
  mfc_getl(global_words, ea, list, sizeof list, kTag, 0, 0);
  wait();
  unsigned int total = 0;
  for (const unsigned int word : global_words) total += word;
  return static_cast<int>(total & 0xffU);
}

int reserve_tags() {
  const unsigned int one = mfc_tag_reserve();
  const unsigned int several = mfc_multi_tag_reserve(4);
  const bool reserved = one == 0 && several == 1 && mfc_multi_tag_reserve(28) == MFC_TAG_INVALID;
  const bool released = mfc_multi_tag_release(several, 4) == MFC_TAG_VALID &&
                        mfc_tag_release(one) == MFC_TAG_VALID && mfc_tag_release(one) == MFC_TAG_INVALID;
  return reserved && released ? 0 : 1;
}

void put_without_waiting(unsigned long long ea) {
  global_words[0] = 0xabcd;
  mfc_put(global_words, ea, 16, kTag, 0, 0);
}

void many_gets(unsigned long long ea) {
  auto* buffer = static_cast<char*>(_malloc_align(32 * 128, 7));
  for (unsigned int i = 0; i < 32; ++i) mfc_get(buffer + i * 128, ea, 128, kTag, 0, 0);
  wait();
}

int run(Probe probe, unsigned long long parameter) {
  alignas(128) unsigned int stack_words[kWords];
  switch (probe) {
    case Probe::return_parameter:
      return static_cast<int>(parameter);
    case Probe::exit_with_parameter:
      std::exit(static_cast<int>(parameter));
    case Probe::stop_twice:
      spu_stop(0x123);
      spu_stop(0x124);
      return 3;
    case Probe::stop_inside_a_handler:
      return stop_inside_a_handler();
    case Probe::halt:
      spu_emu_halt();
      return 1;
    case Probe::misaligned_get:
      mfc_get(global_words, parameter + 8, 32, kTag, 0, 0);
      return 1;
    case Probe::bad_channel:
      spu_writech(SPU_RdInMbox, 1);
      return 1;
    case Probe::count_runs:
      return ++runs;
    case Probe::sum_into_global:
      return sum(global_words, parameter);
    case Probe::sum_into_stack:
      return sum(stack_words, parameter);
    case Probe::sum_into_heap:
      return sum_into_heap(parameter);
    case Probe::put_constant:
      mfc_put(const_cast<unsigned int*>(kConstant), parameter, 16, kTag, 0, 0);
      wait();
      return 0;
    case Probe::get_to_foreign_pointer:
      mfc_get(reinterpret_cast<void*>(parameter), parameter, 16, kTag, 0, 0);
      return 1;
    case Probe::get_to_deep_stack:
      get_to_deep_stack(parameter);
      return 1;
    case Probe::allocate_until_full:
      return allocate_until_full(parameter);
    case Probe::use_the_heap:
      return use_the_heap();
    case Probe::free_twice:
      free_twice();
      return 1;
    case Probe::library_call:
      return library_call();
    case Probe::plain_library_stop:
      spu_stop(0x2110);
      return 9;
    case Probe::check_rounding:
      return (_mm_getcsr() & 0xffc0U) == 0xffc0U ? 0 : 1;
    case Probe::echo_mailbox:
      return echo_mailbox();
    case Probe::answer_to_signal:
      return static_cast<int>(spu_read_signal1() + spu_read_signal2());
    case Probe::read_without_waiting:
      return read_without_waiting(parameter);
    case Probe::write_without_waiting:
      write_without_waiting(parameter);
      return 1;
    case Probe::list_on_stack:
      return list_on_stack(parameter);
    case Probe::reserve_tags:
      return reserve_tags();
    case Probe::put_without_waiting:
      put_without_waiting(parameter);
      return 0;
    case Probe::many_gets:
      many_gets(parameter);
      return 0;
    case Probe::send_global_and_wait:
      return send_global_and_wait();
    case Probe::own_arguments:
      return 0;
  }
  return 99;
}

}  // namespace

int main(unsigned long long speid, unsigned long long argp, unsigned long long envp) {
  if (static_cast<Probe>(argp) == Probe::own_arguments)
    return speid == envp && lifetime.word == 0x600d ? 0 : 1;
  return run(static_cast<Probe>(argp), envp);
}
