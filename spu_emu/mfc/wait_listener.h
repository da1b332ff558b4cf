/// @file
/// Who is told, and who may ask, while an SPU waits in a channel.
#ifndef SPU_EMU_MFC_WAIT_LISTENER_H
#define SPU_EMU_MFC_WAIT_LISTENER_H

#include <atomic>
#include <chrono>
#include <optional>

namespace spu_emu {

/// Called by the SPU's own thread, many times a second, for as long as it waits.
class WaitListener {
 public:
  /// `what` it waits for, as WaitState says it.
  virtual void still_waiting(const char* what) = 0;

 protected:
  ~WaitListener() = default;
};

/// What an SPU waits for, and since when; any thread may ask.
class WaitState {
 public:
  struct Wait {
    const char* what;  // in a few words, for example "read in mailbox"
    std::chrono::steady_clock::time_point since;
  };

  /// By the SPU's thread. `what` is a literal.
  void begin(const char* what) {
    since_.store(std::chrono::steady_clock::now().time_since_epoch().count(), std::memory_order_relaxed);
    what_.store(what, std::memory_order_release);
  }
  void end() { what_.store(nullptr, std::memory_order_release); }

  std::optional<Wait> now() const {
    const char* what = what_.load(std::memory_order_acquire);
    if (what == nullptr) return std::nullopt;
    const std::chrono::steady_clock::duration since(since_.load(std::memory_order_relaxed));
    return Wait{what, std::chrono::steady_clock::time_point(since)};
  }

 private:
  std::atomic<const char*> what_{nullptr};
  std::atomic<std::chrono::steady_clock::rep> since_{0};
};

/// A wait from construction to destruction.
class Waiting {
 public:
  Waiting(WaitState& state, const char* what) : state_(state) { state_.begin(what); }
  ~Waiting() { state_.end(); }
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;

 private:
  WaitState& state_;
};

}  // namespace spu_emu

#endif
