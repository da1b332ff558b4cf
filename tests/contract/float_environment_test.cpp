/// @file
/// The caller's rounding, denormals and traps: they change no answer, whichever call they come with, and are
/// as they were when a call returns.
#include <cfenv>
#include <cstdint>
#include <vector>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/effort.h"
#include "contract/random.h"
#include "contract/random_caller.h"
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace cellsweep::contract {
namespace {

#if defined(__SSE2__)

/// Of MXCSR.
constexpr unsigned kExceptionsThatHappened = 0x3f;

unsigned settings() {
  return _mm_getcsr() & ~kExceptionsThatHappened;
}
void set(unsigned settings) {
  _mm_setcsr(settings);
}

/// Four roundings, with results that are denormal flushed, arguments that are taken for 0, everything
/// trapped, or not.
std::vector<unsigned> all_settings() {
  std::vector<unsigned> all;
  for (const unsigned rounding : {0x0000U, 0x2000U, 0x4000U, 0x6000U}) {
    for (const unsigned flush : {0x0000U, 0x8000U}) {
      for (const unsigned zero : {0x0000U, 0x0040U}) {
        for (const unsigned masks : {0x1f80U, 0x0000U}) all.push_back(rounding | flush | zero | masks);
      }
    }
  }
  return all;
}

#elif defined(__aarch64__)

std::uint64_t settings() {
  std::uint64_t fpcr = 0;
  asm volatile("mrs %0, fpcr" : "=r"(fpcr));
  return fpcr;
}
void set(std::uint64_t settings) {
  asm volatile("msr fpcr, %0" : : "r"(settings) : "memory");
}

/// FPCR: four roundings, denormals flushed or not. Many of these processors trap nothing.
std::vector<std::uint64_t> all_settings() {
  std::vector<std::uint64_t> all;
  for (const std::uint64_t rounding : {0U, 1U, 2U, 3U}) {
    for (const std::uint64_t flush : {0U, 1U}) all.push_back(rounding << 22U | flush << 24U);
  }
  return all;
}

#else

int settings() {
  return std::fegetround();
}
void set(int settings) {
  std::fesetround(settings);
}
std::vector<int> all_settings() {
  return {FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO};
}

#endif

/// The settings of the next call, and those that the thread has between calls.
class Environment {
 public:
  explicit Environment(std::uint64_t seed) : random_(seed) {}

  void operator()(bool before) {
    if (before) {
      of_call_ = all_[random_.below(all_.size())];
      set(of_call_);
      return;
    }
    const auto found = settings();
    set(usual_);
    EXPECT_EQ(found, of_call_) << "the call left other settings than it found";
  }

 private:
  decltype(all_settings()) all_ = all_settings();
  decltype(settings()) usual_ = settings();
  decltype(settings()) of_call_ = usual_;
  Random random_;
};

using FloatEnvironmentContract = PerEngine;

TEST_P(FloatEnvironmentContract, IsTheCallersAndChangesNoAnswer) {
  for (const char* name : {"uniform", "last_bits", "around_zero", "extreme_values"}) {
    const BoxKind& kind = box_kind(name);
    for (std::uint64_t seed = 0; seed < repeated(4U, effort(4U, 1U, 1U)); ++seed) {
      CheckedEngine checked(GetParam(), story_of(kind, 40, seed) + ", floating-point settings of all kinds");
      checked.surround_calls(Environment(seed));
      RandomCaller caller(checked, kind, 40, seed);
      ASSERT_TRUE(caller.fill());
      for (int step = 0; step < effort(12, 3); ++step) ASSERT_TRUE(caller.step());
      ASSERT_EQ(checked.failures(), 0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, FloatEnvironmentContract, all_engines(), engine_label);

}  // namespace
}  // namespace cellsweep::contract
