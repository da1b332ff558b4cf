/// @file
/// Threads that wait for work without sleeping at first, so that a frame does not pay for waking them.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace cellsweep::stream {

/// A crew of workers, the calling thread one of them. Threads start when they are first needed; where the
/// system does not give as many, there are fewer workers. One caller at a time.
class Pool {
 public:
  /// `workers` counts the caller: 1 never starts a thread.
  explicit Pool(unsigned workers);
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
  ~Pool();

  /// The most workers there can be; use() may find that there are fewer.
  unsigned workers() const { return workers_; }

  /// The workers that the next jobs are run by, 1 to workers().
  unsigned active() const { return active_; }
  void use(unsigned workers);

  /// Calls `job(worker)` once for each active worker, 0 on the calling thread, and returns when all have
  /// returned. Throws on the caller's side what a job threw.
  template <class Job>
  void run(const Job& job) {
    if (active_ == 1) return job(0U);
    run_all([](const void* context, unsigned worker) { (*static_cast<const Job*>(context))(worker); }, &job);
  }

  /// Calls `job(worker, index)` for every index below `count`, in chunks that workers take as they get to it.
  template <class Job>
  void for_each(std::size_t count, std::size_t chunk, const Job& job) {
    if (active_ == 1) {
      for (std::size_t index = 0; index < count; ++index) job(0U, index);
      return;
    }
    std::atomic<std::size_t> next = 0;
    const auto work = [&](unsigned worker) {
      for (std::size_t first = next.fetch_add(chunk); first < count; first = next.fetch_add(chunk)) {
        const std::size_t last = first + chunk < count ? first + chunk : count;
        for (std::size_t index = first; index < last; ++index) job(worker, index);
      }
    };
    run(work);
  }

  /// The seconds that handing an empty job to all workers takes; measured once, at the first call.
  double seconds_to_dispatch();

 private:
  using Call = void (*)(const void*, unsigned);

  void run_all(Call call, const void* context);
  void start_threads();
  void work(unsigned worker);
  void call(unsigned worker);
  void wait_for_others();

  unsigned workers_;
  unsigned active_;
  std::vector<std::thread> threads_;
  Call call_ = nullptr;
  const void* context_ = nullptr;
  int spins_;
  bool stop_ = false;
  double dispatch_ = -1;
  alignas(64) std::atomic<std::uint32_t> job_ = 0;      // counts jobs; threads wait for it to change
  alignas(64) std::atomic<std::uint32_t> running_ = 0;  // threads that have not finished the job
  std::mutex error_mutex_;
  std::exception_ptr error_;
};

/// The part of 0 … count − 1 that belongs to one of `workers`, by place.
struct Share {
  std::size_t first = 0;
  std::size_t last = 0;

  static Share of(std::size_t count, unsigned worker, unsigned workers) {
    return {count * worker / workers, count * (worker + 1) / workers};
  }
};

}  // namespace cellsweep::stream
