/// @file
/// A stack of its own for an SPU program, so that it can stop in the middle and go on later.
#ifndef SPU_EMU_HOST_FIBER_H
#define SPU_EMU_HOST_FIBER_H

#include <ucontext.h>

#include <array>
#include <cstddef>

namespace spu_emu {

/// Runs a function on a given stack. resume() goes there on the calling thread, suspend() comes back; what is
/// on the stack when the fiber ends is abandoned, no destructor runs. One thread at a time; the threads may
/// differ.
class Fiber {
 public:
  using Entry = void (*)(void*);

  /// `stack` is memory of the caller's that lives as long as the fiber. `entry` must not return, but suspend
  /// for good.
  Fiber(std::byte* stack, std::size_t size, Entry entry, void* argument);
  ~Fiber();
  Fiber(const Fiber&) = delete;
  Fiber& operator=(const Fiber&) = delete;

  /// Called outside: runs the function until it suspends.
  void resume();
  /// Called inside: returns from resume(), and comes back when that is called again.
  void suspend();

 private:
  static void start(unsigned high, unsigned low);
  void swap_exception_state();

  std::byte* stack_;
  std::size_t size_;
  Entry entry_;
  void* argument_;
  ucontext_t inside_{};
  ucontext_t outside_{};
  /// What the C++ runtime keeps for each thread: the exceptions being handled.
  std::array<std::byte, 2 * sizeof(void*)> exceptions_{};
  const void* outside_stack_ = nullptr;
  std::size_t outside_size_ = 0;
  void* inside_fake_stack_ = nullptr;
  void* outside_fake_stack_ = nullptr;
  void* inside_thread_ = nullptr;
  void* outside_thread_ = nullptr;
};

}  // namespace spu_emu

#endif
