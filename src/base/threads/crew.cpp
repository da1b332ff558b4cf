#include "base/threads/crew.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <limits>
#include <mutex>
#include <utility>

#include "base/float_environment.h"
#include "base/tuning.h"

namespace cellsweep {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

Crew::Crew(std::shared_ptr<Executor> executor, unsigned workers, Choice choice)
    : executor_(std::move(executor)),
      workers_(workers),
      active_(workers),
      choice_(choice),
      costs_of_new_(std::numeric_limits<std::size_t>::digits + 1, WorkCost(tuning::kFullGuess)) {}

void Crew::use(unsigned workers) {
  active_ = std::clamp(workers, 1U, workers_);
}

// Workers are woken for the first time when they would have saved by now what starting threads costs.
void Crew::plan(std::size_t items, double seconds_of_item) {
  if (choice_ == Choice::given) return use(items / tuning::kLeastItems >= workers_ ? workers_ : 1);
  const double seconds_of_one = static_cast<double>(items) * seconds_of_item;
  use(1);
  if (seconds_of_one < tuning::kTooSmall || workers_ == 1) return;
  const double saved = seconds_of_one * (1 - 1.0 / workers_);
  missed_ += saved;
  if (!has_started()) return;
  if (saved > 2 * tuning::kJobs * seconds_to_dispatch()) return use(workers_);
  // What was measured at a bad moment must not keep the workers from ever being used.
  if (++unused_ % tuning::kPatience == 0) dispatch_ = -1;
}

void Crew::plan(std::size_t items, const WorkCost& cost) {
  if (choice_ == Choice::by_gain && !cost.by_all()) return use(1);
  plan(items, cost.seconds());
}

TimedWork::TimedWork(Crew& crew, std::size_t items, WorkCost& cost)
    : crew_(crew), cost_(nullptr), items_(items) {
  crew.plan(items, cost);
  const bool is_small = static_cast<double>(items) * cost.seconds() < tuning::kTooSmall;
  if (is_small && items < tuning::kLeastTimed) return;
  cost_ = &cost;
  start_ = WorkCost::Clock::now();
}

TimedWork::~TimedWork() {
  if (cost_ != nullptr) cost_->learn(WorkCost::Clock::now() - start_, crew_.active(), items_);
}

// What a task throws must not pass through an executor that is not ours, whose threads may have
// floating-point settings of their own.
void Crew::run_all(Call call, const void* context) {
  struct Job {
    Call call;
    const void* context;
    std::mutex mutex{};
    std::exception_ptr error{};
  } job{call, context};
  const auto task = [](void* of, unsigned worker) {
    Job& now = *static_cast<Job*>(of);
    const DefaultFloats floats;
    try {
      now.call(now.context, worker);
    } catch (...) {
      const std::lock_guard lock(now.mutex);
      now.error = std::current_exception();
    }
  };
  executor_->run(active_, task, &job);
  if (job.error) std::rethrow_exception(job.error);
}

// By how much tasks that take a while take longer where all workers have one than where the caller alone has:
// until another thread takes one. The quickest of a few: the system delays one now and then.
double Crew::seconds_to_dispatch() {
  if (dispatch_ >= 0) return dispatch_;
  const auto take_a_while = [](unsigned) {
    const Clock::time_point start = Clock::now();
    while (Clock::now() - start < std::chrono::duration<double>(tuning::kTrialTask)) continue;
  };
  const unsigned before = active_;
  use(workers_);
  run(take_a_while);
  double quickest = 1;
  for (int i = 0; i < tuning::kDispatches; ++i) {
    const Clock::time_point start = Clock::now();
    run(take_a_while);
    quickest = std::min(quickest, seconds_since(start));
  }
  dispatch_ = std::max(quickest - tuning::kTrialTask, 0.0);
  use(before);
  return dispatch_;
}

}  // namespace cellsweep
