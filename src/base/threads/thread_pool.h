/// @file
/// The library's own executor: threads that wait for work without sleeping at first, so that a frame does not
/// pay for waking them.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>
#include <vector>

#include "base/process.h"
#include "cellsweep/executor.h"

namespace cellsweep {

/// The processors of this machine that the program may use; asked for once.
unsigned machine_threads();

/// Threads start when they are first needed. Tasks that no thread has begun when the caller has done its own
/// are done by the caller: nobody waits for a thread that starts, wakes up late or is not to be had. One
/// caller at a time. In a child of fork() threads start anew.
class ThreadPool final : public Executor {
 public:
  /// `concurrency` counts the caller: 1 never starts a thread.
  explicit ThreadPool(unsigned concurrency);
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  [[gnu::cold]] ~ThreadPool() override;

  unsigned concurrency() const override { return concurrency_; }
  /// Not inlined, for the size of programs.
  [[gnu::noinline]] void run(unsigned count, Task task, void* context) override;

 private:
  [[gnu::cold]] void leave_threads_of_parent();
  [[gnu::cold]] void start_threads();
  void work();
  void do_tasks_left();
  void wait_for_others();

  unsigned concurrency_;
  int spins_;
  std::uint32_t refused_ = 0;  // jobs since the system gave no more threads
  std::atomic<bool> stop_ = false;
  ProcessMark process_;
  std::unique_ptr<std::vector<std::thread>> threads_;  // null: none were needed yet
  Task task_ = nullptr;
  void* context_ = nullptr;
  alignas(64) std::atomic<std::uint32_t> job_ = 0;      // counts jobs; threads wait for it to change
  alignas(64) std::atomic<std::uint32_t> left_ = 0;     // tasks that nobody has begun: 1 ... left_
  alignas(64) std::atomic<std::uint32_t> running_ = 0;  // tasks but the first that have not returned
};

}  // namespace cellsweep
