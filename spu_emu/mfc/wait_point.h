/// @file
/// A place to wait for a state that other threads change: spins briefly, then sleeps.
#ifndef SPU_EMU_MFC_WAIT_POINT_H
#define SPU_EMU_MFC_WAIT_POINT_H

#include <sched.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>

namespace spu_emu {

/// All functions may be called from any thread. The states waited for must be atomic or locked by themselves.
class WaitPoint {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// `also` is woken too by every notify; it outlives this object. Null for none.
  explicit WaitPoint(WaitPoint* also = nullptr) : also_(also) {}

  /// To be called after every change that somebody may wait for; cheap when nobody sleeps.
  void notify();

  /// Returns when `ready()` is true.
  template <class Ready>
  void wait(Ready&& ready) {
    wait_until(ready, Time::max());
  }

  /// Returns true when `ready()` is true, false when `deadline` passed before. `ready` is called without a
  /// lock.
  template <class Ready>
  bool wait_until(Ready&& ready, Time deadline) {
    if (spin(ready)) return true;
    const Sleeper sleeper(*this);
    for (;;) {
      const std::uint64_t seen = wakes_.load();
      if (ready()) return true;
      if (!sleep(seen, deadline)) return ready();
    }
  }

 private:
  /// Counts a thread as asleep. It does so before it looks at the state for the last time, and notify() looks
  /// at the count after the state changed: one of the two always sees the other.
  struct Sleeper {
    explicit Sleeper(WaitPoint& point) : point_(point) { point_.sleepers_.fetch_add(1); }
    ~Sleeper() { point_.sleepers_.fetch_sub(1); }
    Sleeper(const Sleeper&) = delete;
    Sleeper& operator=(const Sleeper&) = delete;
    WaitPoint& point_;
  };

  /// Leaves the core to its other thread for a moment.
  static void relax() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#elif defined(__powerpc__)
    asm volatile("or 27,27,27" ::: "memory");
#endif
  }

  template <class Ready>
  static bool spin(Ready& ready) {
    for (int round = 0; round < kSpinRounds; ++round) {
      if (ready()) return true;
      if (round % kYieldEvery == kYieldEvery - 1 && !yield()) break;
      relax();
    }
    return ready();
  }

  /// More SPEs than processors: the thread waited for may be waiting for this processor. False when somebody
  /// had it for long, who would get another time slice each time; one who sleeps is woken before that is
  /// over.
  static bool yield() {
    const Time before = std::chrono::steady_clock::now();
    sched_yield();
    return std::chrono::steady_clock::now() - before < kLongYield;
  }

  /// Sleeps until somebody wakes after the count was `seen`; false when the deadline passed.
  bool sleep(std::uint64_t seen, Time deadline);
  void wake();

  /// About ten microseconds: longer than a mailbox answer from another core, shorter than a time slice.
  static constexpr int kSpinRounds = 300;
  static constexpr int kYieldEvery = 16;
  /// Longer than an SPE takes for its part of a step, shorter than a time slice. Chosen, not measured.
  static constexpr std::chrono::microseconds kLongYield{200};

  WaitPoint* also_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::atomic<std::uint64_t> wakes_{0};
  std::atomic<std::uint64_t> notifies_{0};
  std::atomic<int> sleepers_{0};
};

}  // namespace spu_emu

#endif
