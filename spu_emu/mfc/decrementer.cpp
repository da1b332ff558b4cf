#include "mfc/decrementer.h"

namespace spu_emu {

std::uint64_t SteadyTimebase::ticks() const {
  const std::chrono::duration<double> now = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<std::uint64_t>(now.count() * hertz_);
}

std::chrono::nanoseconds SteadyTimebase::duration(std::uint64_t ticks) const {
  return std::chrono::nanoseconds(static_cast<std::int64_t>(static_cast<double>(ticks) * 1e9 / hertz_));
}

void Decrementer::write(std::uint32_t value) {
  start_ = timebase_.ticks();
  value_ = value;
  running_ = true;
  armed_ = true;
}

std::uint32_t Decrementer::read() const {
  return running_ ? value_ - static_cast<std::uint32_t>(elapsed()) : 0;
}

bool Decrementer::take_event() {
  if (!armed_ || elapsed() <= value_) return false;
  armed_ = false;
  return true;
}

std::chrono::nanoseconds Decrementer::until_event() const {
  const std::uint64_t gone = elapsed();
  return timebase_.duration(gone > value_ ? 0 : value_ + 1 - gone);
}

}  // namespace spu_emu
