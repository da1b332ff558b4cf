/// @file
/// Tells a process from one that fork() made of it, in which the threads of the other do not exist.
#pragma once

#include <atomic>
#include <cstdint>

#if __has_include(<pthread.h>)
#include <pthread.h>
#endif

namespace cellsweep {

/// How many calls of fork() this process is away from its first ancestor that asked.
inline std::uint32_t process_generation() {
  static std::atomic<std::uint32_t> generation = 0;
#if __has_include(<pthread.h>)
  static const int watches = pthread_atfork(nullptr, nullptr, [] { ++generation; });
  static_cast<void>(watches);
#endif
  return generation.load(std::memory_order_relaxed);
}

/// Remembers in which process something was made that other threads take part in.
class ProcessMark {
 public:
  /// False in a child of fork(): threads that were started before are not there, and nobody may wait for
  /// them.
  bool is_this_process() const { return generation_ == process_generation(); }

  /// As if made now.
  void renew() { generation_ = process_generation(); }

 private:
  std::uint32_t generation_ = process_generation();
};

}  // namespace cellsweep
