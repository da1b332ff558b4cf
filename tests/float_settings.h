/// @file
/// What a program may make of the processor's floating-point arithmetic: rounding, denormals and traps.
#pragma once

#include <cfenv>
#include <cstdint>
#include <vector>
#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace cellsweep {

#if defined(__SSE2__)

/// Of MXCSR.
inline constexpr unsigned kExceptionsThatHappened = 0x3f;

inline unsigned float_settings() {
  return _mm_getcsr() & ~kExceptionsThatHappened;
}
inline void set_float_settings(unsigned settings) {
  _mm_setcsr(settings);
}

/// Four roundings, with results that are denormal flushed, arguments that are taken for 0, everything
/// trapped, or not.
inline std::vector<unsigned> all_float_settings() {
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

inline std::uint64_t float_settings() {
  std::uint64_t fpcr = 0;
  asm volatile("mrs %0, fpcr" : "=r"(fpcr));
  return fpcr;
}
inline void set_float_settings(std::uint64_t settings) {
  asm volatile("msr fpcr, %0" : : "r"(settings) : "memory");
}

/// FPCR: four roundings, denormals flushed, NaNs made the default one, everything trapped, or not. Many of
/// these processors trap nothing, and forget that they were asked to.
inline std::vector<std::uint64_t> all_float_settings() {
  std::vector<std::uint64_t> all;
  for (const std::uint64_t rounding : {0U, 1U, 2U, 3U}) {
    for (const std::uint64_t flush : {0U, 1U}) {
      for (const std::uint64_t nans : {0U, 1U}) {
        for (const std::uint64_t traps : {0x0000U, 0x9f00U})
          all.push_back(rounding << 22U | flush << 24U | nans << 25U | traps);
      }
    }
  }
  return all;
}

#else

inline int float_settings() {
  return std::fegetround();
}
inline void set_float_settings(int settings) {
  std::fesetround(settings);
}
inline std::vector<int> all_float_settings() {
  return {FE_TONEAREST, FE_DOWNWARD, FE_UPWARD, FE_TOWARDZERO};
}

#endif

/// While it lives, this thread has these settings.
class FloatSettings {
 public:
  explicit FloatSettings(decltype(float_settings()) now) : before_(float_settings()) {
    set_float_settings(now);
  }
  FloatSettings(const FloatSettings&) = delete;
  FloatSettings& operator=(const FloatSettings&) = delete;
  ~FloatSettings() { set_float_settings(before_); }

 private:
  decltype(float_settings()) before_;
};

}  // namespace cellsweep
