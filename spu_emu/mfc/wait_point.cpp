#include "mfc/wait_point.h"

namespace spu_emu {

void WaitPoint::notify() {
  notifies_.fetch_add(1);  // Orders the caller's change of state before the look at the sleepers.
  wake();
  if (also_ != nullptr) also_->wake();
}

void WaitPoint::wake() {
  if (sleepers_.load() == 0) return;
  {
    const std::lock_guard lock(mutex_);
    wakes_.fetch_add(1);
  }
  changed_.notify_all();
}

bool WaitPoint::sleep(std::uint64_t seen, Time deadline) {
  std::unique_lock lock(mutex_);
  const auto woken = [&] { return wakes_.load() != seen; };
  if (deadline != Time::max()) return changed_.wait_until(lock, deadline, woken);
  changed_.wait(lock, woken);
  return true;
}

}  // namespace spu_emu
