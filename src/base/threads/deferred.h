/// @file
/// Work that is put off until somebody needs it.
#pragma once

#include <atomic>
#include <mutex>

namespace cellsweep {

/// What is left to do is done by the first of any number of threads that need it, while the others wait. It
/// moves with the object that it is a part of.
class Deferred {
 public:
  Deferred() = default;
  Deferred(Deferred&& other) noexcept : waits_(other.waits()) {}
  Deferred& operator=(Deferred&& other) noexcept {
    put_off(other.waits());
    return *this;
  }
  ~Deferred() = default;

  bool waits() const { return waits_.load(std::memory_order_acquire); }

  /// From now on something is left to do, or nothing. Not at the same time as any other call.
  void put_off(bool waits = true) { waits_.store(waits, std::memory_order_relaxed); }

  /// Does it where it is left to do. What `work` throws passes through, and it is still left to do.
  template <class Work>
  void finish(const Work& work) const {
    if (!waits()) return;
    const std::lock_guard lock(mutex_);
    if (!waits_.load(std::memory_order_relaxed)) return;
    work();
    waits_.store(false, std::memory_order_release);
  }

  /// A look at what is written there, while nobody does it.
  template <class Look>
  void while_nobody(const Look& look) const {
    const std::lock_guard lock(mutex_);
    look();
  }

 private:
  mutable std::atomic<bool> waits_ = false;
  mutable std::mutex mutex_;
};

}  // namespace cellsweep
