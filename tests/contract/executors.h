/// @file
/// Job systems as a caller might bring them, and some that no caller would.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <new>
#include <thread>
#include <vector>

#include "cellsweep/executor.h"

namespace cellsweep::contract {

/// More than most machines of the tests have cores, so that tasks wait their turn.
inline constexpr unsigned kConcurrency = 3;

/// One task after the other, on the calling thread.
class SequentialExecutor : public Executor {
 public:
  unsigned concurrency() const override { return kConcurrency; }
  void run(unsigned count, Task task, void* context) override {
    for (unsigned i = 0; i < count; ++i) task(context, i);
  }
};

/// The last task first.
class ReversingExecutor : public Executor {
 public:
  unsigned concurrency() const override { return kConcurrency; }
  void run(unsigned count, Task task, void* context) override {
    for (unsigned i = count; i-- > 0;) task(context, i);
  }
};

/// No task on the calling thread, each on one of its own that is new.
class ThreadPerTaskExecutor : public Executor {
 public:
  unsigned concurrency() const override { return kConcurrency; }
  void run(unsigned count, Task task, void* context) override {
    std::vector<std::jthread> threads;
    threads.reserve(count);
    for (unsigned i = 0; i < count; ++i) threads.emplace_back(task, context, i);
  }
};

/// All tasks on one thread that is not the calling one.
class OtherThreadExecutor : public Executor {
 public:
  unsigned concurrency() const override { return kConcurrency; }
  void run(unsigned count, Task task, void* context) override {
    std::jthread([&] {
      for (unsigned i = 0; i < count; ++i) task(context, i);
    }).join();
  }
};

/// Has no memory for the n-th run(), once.
class StarvedExecutor : public SequentialExecutor {
 public:
  explicit StarvedExecutor(std::uint64_t n) : left_(n) {}

  void run(unsigned count, Task task, void* context) override {
    if (left_ > 0 && --left_ == 0) throw std::bad_alloc();
    SequentialExecutor::run(count, task, context);
  }

 private:
  std::uint64_t left_;
};

/// Watches whether a Broadphase keeps what it promises to an executor.
class WatchfulExecutor : public SequentialExecutor {
 public:
  /// `most` tasks at a time were asked for.
  explicit WatchfulExecutor(unsigned most) : most_(most) {}

  void run(unsigned count, Task task, void* context) override {
    if (busy_.exchange(true)) kept_ = false;
    if (count > concurrency() || count > most_) kept_ = false;
    most_seen_ = std::max(most_seen_, count);
    SequentialExecutor::run(count, task, context);
    busy_ = false;
  }

  /// Never more tasks than there may be, and never two calls at a time.
  bool promises_were_kept() const { return kept_; }
  /// The most tasks that one run() had.
  unsigned most_seen() const { return most_seen_; }

 private:
  unsigned most_;
  unsigned most_seen_ = 0;
  bool kept_ = true;
  std::atomic<bool> busy_ = false;
};

#ifdef CELLSWEEP_HAS_TBB
/// Tasks of oneTBB. Safe to call from any thread.
std::shared_ptr<Executor> make_tbb_executor();
#endif

}  // namespace cellsweep::contract
