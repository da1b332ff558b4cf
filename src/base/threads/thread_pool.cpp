#include "base/threads/thread_pool.h"

#include <algorithm>
#include <system_error>

namespace cellsweep {
namespace {

/// Looks at an atomic this often before the operating system is asked to wait: some ten microseconds.
constexpr int kSpins = 1000;

/// Where the system gave no more threads it is asked again after so many jobs: it may have some by then.
constexpr std::uint32_t kJobsUntilRetry = 1000;

void relax() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

/// With more workers than cores, a thread that spins keeps another from working.
int spins_for(unsigned workers) {
  return workers <= machine_threads() ? kSpins : 0;
}

void wait_while(const std::atomic<std::uint32_t>& value, std::uint32_t old, int spins) {
  for (int spin = 0; spin < spins; ++spin) {
    if (value.load(std::memory_order_acquire) != old) return;
    relax();
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

// The system takes microseconds to tell, which is as long as a small broadphase takes to make.
unsigned machine_threads() {
  static const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  return threads;
}

ThreadPool::ThreadPool(unsigned concurrency)
    : concurrency_(std::max(1U, concurrency)), spins_(concurrency_ > 1 ? spins_for(concurrency_) : 0) {}

ThreadPool::~ThreadPool() {
  leave_threads_of_parent();
  if (!threads_) return;
  stop_ = true;
  job_.fetch_add(1, std::memory_order_release);
  job_.notify_all();
  for (std::thread& thread : *threads_) thread.join();
}

// Threads that fork() did not take along can neither be waited for nor be let go, so what stands for them
// stays for the rest of the process.
void ThreadPool::leave_threads_of_parent() {
  if (process_.is_this_process()) return;
  static_cast<void>(threads_.release());
  refused_ = 0;
  process_.renew();
}

void ThreadPool::start_threads() {
  leave_threads_of_parent();
  if (threads_ && threads_->size() + 1 == concurrency_) return;
  if (refused_ > 0 && ++refused_ <= kJobsUntilRetry) return;
  if (!threads_) threads_ = std::make_unique<std::vector<std::thread>>();
  threads_->reserve(concurrency_ - 1);
  try {
    while (threads_->size() + 1 < concurrency_) threads_->emplace_back([this] { work(); });
    refused_ = 0;
  } catch (const std::system_error&) {
    refused_ = 1;
  }
}

void ThreadPool::work() {
  std::uint32_t seen = 0;
  for (;;) {
    wait_while(job_, seen, spins_);
    const std::uint32_t now = job_.load(std::memory_order_acquire);
    if (now == seen) continue;
    seen = now;
    if (stop_) return;
    do_tasks_left();
  }
}

// A thread that comes late may find the tasks of the next job, which are as good. What the job is may be read
// only with a task of it in hand: the caller waits for that.
void ThreadPool::do_tasks_left() {
  std::uint32_t left = left_.load(std::memory_order_acquire);
  while (left > 0) {
    if (!left_.compare_exchange_weak(left, left - 1, std::memory_order_acq_rel, std::memory_order_acquire))
      continue;
    task_(context_, left);
    if (running_.fetch_sub(1, std::memory_order_acq_rel) == 1) running_.notify_one();
    left = left_.load(std::memory_order_acquire);
  }
}

void ThreadPool::run(unsigned count, Task task, void* context) {
  if (count == 0) return;
  if (count > 1) start_threads();
  if (count == 1 || threads_->empty()) {
    for (unsigned index = 0; index < count; ++index) task(context, index);
    return;
  }
  task_ = task;
  context_ = context;
  running_.store(count - 1, std::memory_order_relaxed);
  left_.store(count - 1, std::memory_order_release);
  job_.fetch_add(1, std::memory_order_release);
  job_.notify_all();
  task(context, 0);
  do_tasks_left();
  wait_for_others();
}

void ThreadPool::wait_for_others() {
  for (;;) {
    const std::uint32_t left = running_.load(std::memory_order_acquire);
    if (left == 0) return;
    wait_while(running_, left, spins_);
  }
}

}  // namespace cellsweep
