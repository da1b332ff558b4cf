// Eight SPEs count together in one word of main memory.
#include <array>
#include <thread>
#include <vector>

#include "run_spe.h"

extern "C" spe_program_handle_t atomic_counter_spu;

namespace {
constexpr unsigned int kSpes = 8;
constexpr std::uintptr_t kTimes = 2000;

struct alignas(128) Line {
  unsigned int words[32];
};

bool count(spe_context_ptr_t spe, Line& line) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  return spe_context_run(spe, &entry, 0, &line, reinterpret_cast<void*>(kTimes), &stop) == 0;
}
}  // namespace

int main(int argc, char** argv) {
  set_mode_from_arguments(argc, argv);
  Line line{};
  std::array<spe_context_ptr_t, kSpes> spes{};
  for (auto& spe : spes) spe = load_spe(atomic_counter_spu);
  std::array<bool, kSpes> ran{};
  std::vector<std::thread> threads;
  for (unsigned int i = 0; i < kSpes; ++i) threads.emplace_back([&, i] { ran[i] = count(spes[i], line); });
  for (auto& thread : threads) thread.join();
  bool right = line.words[0] == kSpes * kTimes;
  for (unsigned int i = 0; i < kSpes; ++i) {
    right = right && ran[i];
    spe_context_destroy(spes[i]);
  }
  std::printf("counted %u, expected %u\n", line.words[0], static_cast<unsigned int>(kSpes * kTimes));
  return right ? EXIT_SUCCESS : EXIT_FAILURE;
}
