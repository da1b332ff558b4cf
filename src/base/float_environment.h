/// @file
/// The processor's floating-point settings: the library computes with the default ones, whatever its caller
/// has set, so that one number never comes out in two ways.
#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <xmmintrin.h>
#elif !defined(__aarch64__)
#include <cfenv>
#endif

namespace cellsweep {

/// While it lives, the calling thread rounds to nearest, keeps denormals and traps nothing. Then it does
/// again what it did before. Costs a read where nothing has to change.
class DefaultFloats {
 public:
#if defined(__SSE2__) || defined(__aarch64__)
  DefaultFloats() : before_(settings()) {
    if (controls(before_) != kDefault) set(kDefault);
  }
  ~DefaultFloats() {
    if (controls(before_) != kDefault) set(before_);
  }
#else
  DefaultFloats() {
    std::fegetenv(&before_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultFloats() {
    std::fesetenv(&before_);
  }
#endif
  DefaultFloats(const DefaultFloats&) = delete;
  DefaultFloats& operator=(const DefaultFloats&) = delete;

 private:
#if defined(__SSE2__)
  static constexpr std::uint32_t kDefault = 0x1f80;  // MXCSR: all exceptions masked, the rest 0
  static constexpr std::uint32_t kFlags = 0x3f;      // exceptions that have happened

  static std::uint32_t settings() {
    return _mm_getcsr();
  }
  static std::uint32_t controls(std::uint32_t settings) {
    return settings & ~kFlags;
  }
  static void set(std::uint32_t settings) {
    _mm_setcsr(settings);
  }

  std::uint32_t before_;
#elif defined(__aarch64__)
  static constexpr std::uint64_t kDefault = 0;  // FPCR; what has happened stands in another register

  static std::uint64_t settings() {
    std::uint64_t fpcr = 0;
    asm volatile("mrs %0, fpcr" : "=r"(fpcr));
    return fpcr;
  }
  static std::uint64_t controls(std::uint64_t settings) {
    return settings;
  }
  static void set(std::uint64_t settings) {
    asm volatile("msr fpcr, %0" : : "r"(settings) : "memory");
  }

  std::uint64_t before_;
#else
  std::fenv_t before_;
#endif
};

}  // namespace cellsweep
