/// @file
/// The SPU decrementer: counts down at the timebase and tells when it has passed zero.
#ifndef SPU_EMU_MFC_DECREMENTER_H
#define SPU_EMU_MFC_DECREMENTER_H

#include <chrono>
#include <cstdint>

namespace spu_emu {

/// The clock that a decrementer counts: real time for one engine, simulated cycles for another.
class Timebase {
 public:
  virtual ~Timebase() = default;
  /// Ticks since some start; never goes back.
  virtual std::uint64_t ticks() const = 0;
  /// Real time that `ticks` take; what a blocked SPU sleeps at most.
  virtual std::chrono::nanoseconds duration(std::uint64_t ticks) const = 0;
};

/// Real time at a frequency in Hz; a Cell at 3,192 MHz has 79.8 MHz.
class SteadyTimebase : public Timebase {
 public:
  explicit SteadyTimebase(double hertz) : hertz_(hertz) {}
  std::uint64_t ticks() const override;
  std::chrono::nanoseconds duration(std::uint64_t ticks) const override;

 private:
  double hertz_;
};

/// Used by the SPU's own thread only.
class Decrementer {
 public:
  explicit Decrementer(const Timebase& timebase) : timebase_(timebase) {}

  /// Loads the counter, which goes on from there, and arms the event for the next passing of zero.
  void write(std::uint32_t value);
  /// The counter now, modulo 2^32; 0 before the first write.
  std::uint32_t read() const;
  /// True once for every write after which the counter passed zero.
  bool take_event();
  bool armed() const { return armed_; }
  /// Real time until the event; only when armed.
  std::chrono::nanoseconds until_event() const;

 private:
  std::uint64_t elapsed() const { return timebase_.ticks() - start_; }

  const Timebase& timebase_;
  std::uint64_t start_ = 0;
  std::uint32_t value_ = 0;
  bool running_ = false;
  bool armed_ = false;
};

}  // namespace spu_emu

#endif
