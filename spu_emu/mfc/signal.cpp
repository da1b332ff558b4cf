#include "mfc/signal.h"

namespace spu_emu {

void SignalRegister::write(std::uint32_t value) {
  const std::lock_guard lock(mutex_);
  value_ = mode_ == SignalMode::logical_or ? (value_ | value) : value;
  pending_.store(true);
}

bool SignalRegister::try_read(std::uint32_t& value) {
  const std::lock_guard lock(mutex_);
  if (!pending()) return false;
  value = value_;
  value_ = 0;
  pending_.store(false);
  return true;
}

}  // namespace spu_emu
