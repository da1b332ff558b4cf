// A libspe2 context with the probe program in it, for tests of the host engine.
#ifndef SPU_EMU_TESTS_TEST_CONTEXT_H
#define SPU_EMU_TESTS_TEST_CONTEXT_H

#include <gtest/gtest.h>
#include <libspe2.h>

#include <array>
#include <numeric>
#include <string>

#include "probe.h"
#include "spu_emu/emulation.h"

extern "C" spe_program_handle_t spu_emu_probe;

namespace spu_emu {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kWithAsan = true;
#elif defined(__has_feature)
inline constexpr bool kWithAsan = __has_feature(address_sanitizer);
#else
inline constexpr bool kWithAsan = false;
#endif

/// Memory that DMA can reach: 64 words whose sum's low byte is known.
struct alignas(128) Words {
  Words() { std::iota(words.begin(), words.end(), 1U); }
  int sum() const { return static_cast<int>(std::accumulate(words.begin(), words.end(), 0U) & 0xffU); }
  std::array<unsigned int, 64> words{};
};

inline EmulationSettings settings_of(DmaMode mode) {
  EmulationSettings settings;
  settings.dma_mode = mode;
  return settings;
}

class TestContext {
 public:
  explicit TestContext(const EmulationSettings& settings = {}, unsigned int flags = SPE_EVENTS_ENABLE) {
    const SettingsScope scope(settings);
    spe = spe_context_create(flags, nullptr);
    EXPECT_NE(spe, nullptr);
    load_result = spe_program_load(spe, &spu_emu_probe);
  }
  ~TestContext() { EXPECT_EQ(spe_context_destroy(spe), 0); }
  TestContext(const TestContext&) = delete;
  TestContext& operator=(const TestContext&) = delete;

  int run(Probe probe, unsigned long long parameter = 0, unsigned int flags = 0) {
    entry = SPE_DEFAULT_ENTRY;
    return spe_context_run(spe, &entry, flags, reinterpret_cast<void*>(probe),
                           reinterpret_cast<void*>(parameter), &stop);
  }
  int run(Probe probe, const void* parameter) {
    return run(probe, reinterpret_cast<unsigned long long>(parameter));
  }
  int resume() { return spe_context_run(spe, &entry, 0, nullptr, nullptr, &stop); }
  /// Runs a probe that exits; its exit code.
  int exit_code(Probe probe, unsigned long long parameter = 0) {
    EXPECT_EQ(run(probe, parameter), 0) << last_fault(spe);
    EXPECT_EQ(stop.stop_reason, unsigned{SPE_EXIT});
    return stop.result.spe_exit_code;
  }
  int exit_code(Probe probe, const void* parameter) {
    return exit_code(probe, reinterpret_cast<unsigned long long>(parameter));
  }

  spe_context_ptr_t spe = nullptr;
  int load_result = -1;
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop{};
};

}  // namespace spu_emu

#endif
