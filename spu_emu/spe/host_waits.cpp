#include "spe/host_waits.h"

namespace spu_emu {

HostWaits& HostWaits::instance() {
  static HostWaits waits;
  return waits;
}

HostWait::HostWait(std::string what) {
  HostWaits& all = HostWaits::instance();
  const std::lock_guard lock(all.mutex_);
  wait_ = all.waits_.insert(all.waits_.end(), {std::move(what), std::chrono::steady_clock::now()});
}

HostWait::~HostWait() {
  HostWaits& all = HostWaits::instance();
  const std::lock_guard lock(all.mutex_);
  all.waits_.erase(wait_);
}

}  // namespace spu_emu
