/// @file
/// An executor as the engines use it: workers with numbers, jobs as lambdas, and how many of them pay.
#pragma once

#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "base/threads/work_cost.h"
#include "base/tuning.h"
#include "cellsweep/executor.h"

namespace cellsweep {

/// Workers 0 ... active() - 1, the calling thread one of them. One caller at a time.
class Crew {
 public:
  /// How the number of workers is found.
  enum class Choice {
    given,    ///< all of them, as soon as each has a little to do
    by_gain,  ///< all of them when they save several times what waking them takes; else the caller alone
  };

  Crew(std::shared_ptr<Executor> executor, unsigned workers, Choice choice);
  Crew(const Crew&) = delete;
  Crew& operator=(const Crew&) = delete;

  /// The most workers there can be.
  unsigned workers() const { return workers_; }
  /// How many of them work is found in this way.
  Choice choice() const { return choice_; }

  /// The workers that the next jobs are run by, 1 to workers().
  unsigned active() const { return active_; }
  void use(unsigned workers);

  /// Chooses the active workers for so many items of work, each of so many seconds on one thread. Not
  /// inlined, for the size of programs.
  [[gnu::noinline]] void plan(std::size_t items, double seconds_of_item);
  /// Of which it is known by now what they take; all the same for a number of workers that is given.
  void plan(std::size_t items, const WorkCost& cost);

  /// Whether there has been enough work by now for workers that come at a price, by_gain.
  bool has_started() const { return missed_ >= tuning::kStartCost; }

  /// What it takes to find all pairs of so many boxes that nobody has seen before, for each of them: learnt
  /// by all who have had this crew, from about as many.
  WorkCost& cost_of_new(std::size_t boxes) { return costs_of_new_[std::bit_width(boxes)]; }

  /// Calls `job(worker)` once for each active worker and returns when all have returned. Throws what a job
  /// threw, one of them.
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

 private:
  using Call = void (*)(const void*, unsigned);

  void run_all(Call call, const void* context);
  [[gnu::cold]] double seconds_to_dispatch();

  std::shared_ptr<Executor> executor_;
  unsigned workers_;
  unsigned active_;
  Choice choice_;
  double missed_ = 0;                   // seconds that workers would have saved, had there been any
  double dispatch_ = -1;                // seconds that handing an empty job to all takes, once measured
  std::uint64_t unused_ = 0;            // times that this was too much for work that was worth a try
  std::vector<WorkCost> costs_of_new_;  // by the bits of the number of boxes
};

/// Work of so many items, from here to the end of the block: chooses the workers for it, and learns what it
/// took, where that is worth two looks at the clock.
class TimedWork {
 public:
  TimedWork(Crew& crew, std::size_t items, WorkCost& cost);
  TimedWork(const TimedWork&) = delete;
  TimedWork& operator=(const TimedWork&) = delete;
  ~TimedWork();

 private:
  Crew& crew_;
  WorkCost* cost_;  // null: not worth it
  std::size_t items_;
  WorkCost::Clock::time_point start_;
};

/// The part of 0 ... count - 1 that belongs to one of `workers`, by place.
struct Share {
  std::size_t first = 0;
  std::size_t last = 0;

  static Share of(std::size_t count, unsigned worker, unsigned workers) {
    return {count * worker / workers, count * (worker + 1) / workers};
  }
};

}  // namespace cellsweep
