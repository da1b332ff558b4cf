/// @file
/// Which functions of libspe2 threads of the host wait in.
#ifndef SPU_EMU_SPE_HOST_WAITS_H
#define SPU_EMU_SPE_HOST_WAITS_H

#include <chrono>
#include <list>
#include <mutex>
#include <string>

namespace spu_emu {

/// Any thread.
class HostWaits {
 public:
  struct Wait {
    std::string what;  // the function, and of which SPE
    std::chrono::steady_clock::time_point since;
  };

  static HostWaits& instance();

  /// Calls `visit(const Wait&)` for each, the oldest first; none begins or ends meanwhile.
  template <class Visit>
  void for_each(Visit&& visit) {
    const std::lock_guard lock(mutex_);
    for (const Wait& wait : waits_) visit(wait);
  }

 private:
  friend class HostWait;
  std::mutex mutex_;
  std::list<Wait> waits_;
};

/// A wait of the calling thread, from construction to destruction.
class HostWait {
 public:
  explicit HostWait(std::string what);
  ~HostWait();
  HostWait(const HostWait&) = delete;
  HostWait& operator=(const HostWait&) = delete;

 private:
  std::list<HostWaits::Wait>::iterator wait_;
};

}  // namespace spu_emu

#endif
