#include "mfc/spe_directory.h"

#include <algorithm>
#include <mutex>

namespace spu_emu {

SpeDirectory& SpeDirectory::instance() {
  static SpeDirectory directory;
  return directory;
}

void SpeDirectory::add(const SpeWindow& window) {
  const std::unique_lock lock(mutex_);
  windows_[window.base >> kWindowBits] = window;
  largest_local_store_.store(std::max(largest_local_store_.load(), window.local_store_size));
}

void SpeDirectory::remove(std::uint64_t base) {
  const std::unique_lock lock(mutex_);
  windows_.erase(base >> kWindowBits);
}

}  // namespace spu_emu
