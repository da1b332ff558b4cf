#include "engines/stream/pool.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

namespace cellsweep::stream {
namespace {

/// Looks at an atomic this often before the operating system is asked to wait: some ten microseconds.
constexpr int kSpins = 1000;

void relax() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

/// With more workers than cores, a thread that spins keeps another from working.
int spins_for(unsigned workers) {
  return workers <= std::thread::hardware_concurrency() ? kSpins : 0;
}

void wait_while(const std::atomic<std::uint32_t>& value, std::uint32_t old, int spins) {
  for (int spin = 0; spin < spins; ++spin) {
    if (value.load(std::memory_order_acquire) != old) return;
    relax();
  }
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

Pool::Pool(unsigned workers) : workers_(workers), active_(workers), spins_(spins_for(workers)) {}

void Pool::use(unsigned workers) {
  if (workers > 1) start_threads();
  active_ = std::clamp(workers, 1U, workers_);
}

Pool::~Pool() {
  stop_ = true;
  job_.fetch_add(1, std::memory_order_release);
  job_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Pool::start_threads() {
  if (threads_.size() + 1 == workers_) return;
  threads_.reserve(workers_ - 1);
  try {
    while (threads_.size() + 1 < workers_) {
      const auto worker = static_cast<unsigned>(threads_.size() + 1);
      threads_.emplace_back([this, worker] { work(worker); });
    }
  } catch (const std::system_error&) {  // no more to be had
    workers_ = static_cast<unsigned>(threads_.size() + 1);
    active_ = std::min(active_, workers_);
  }
}

void Pool::work(unsigned worker) {
  std::uint32_t seen = 0;
  for (;;) {
    wait_while(job_, seen, spins_);
    const std::uint32_t now = job_.load(std::memory_order_acquire);
    if (now == seen) continue;
    seen = now;
    if (stop_) return;
    if (worker < active_) call(worker);
    if (running_.fetch_sub(1, std::memory_order_acq_rel) == 1) running_.notify_one();
  }
}

void Pool::call(unsigned worker) {
  try {
    call_(context_, worker);
  } catch (...) {
    const std::lock_guard lock(error_mutex_);
    error_ = std::current_exception();
  }
}

void Pool::run_all(Call call_now, const void* context) {
  start_threads();
  call_ = call_now;
  context_ = context;
  running_.store(workers_ - 1, std::memory_order_relaxed);
  job_.fetch_add(1, std::memory_order_release);
  job_.notify_all();
  call(0);
  wait_for_others();
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

void Pool::wait_for_others() {
  for (;;) {
    const std::uint32_t left = running_.load(std::memory_order_acquire);
    if (left == 0) return;
    wait_while(running_, left, spins_);
  }
}

double Pool::seconds_to_dispatch() {
  if (dispatch_ >= 0) return dispatch_;
  using Clock = std::chrono::steady_clock;
  const unsigned before = active_;
  use(workers_);
  run([](unsigned) {});
  const Clock::time_point start = Clock::now();
  run([](unsigned) {});
  dispatch_ = std::chrono::duration<double>(Clock::now() - start).count();
  active_ = before;
  return dispatch_;
}

}  // namespace cellsweep::stream
