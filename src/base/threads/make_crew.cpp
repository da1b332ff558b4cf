#include "base/threads/make_crew.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <utility>

#include "base/threads/thread_pool.h"
#include "base/tuning.h"

namespace cellsweep {
namespace {

/// The ones that were given up last: two, for an engine is often made in the place of one that was not used.
std::array<std::atomic<Crew*>, 2> kept;
std::atomic<bool> is_over = false;

/// The threads end before the code that they run is unloaded. An engine may be destroyed later.
struct EndOfKeeping {
  ~EndOfKeeping() {
    is_over = true;
    for (std::atomic<Crew*>& place : kept) delete place.exchange(nullptr);
  }
} end_of_keeping;

[[gnu::cold]] void keep(Crew* crew) {
  if (!is_over) {
    for (std::atomic<Crew*>& place : kept) crew = crew != nullptr ? place.exchange(crew) : nullptr;
  }
  delete crew;
}

// What does not fit may fit the next who asks.
[[gnu::cold]] Crew* take_kept(unsigned workers, Crew::Choice choice) {
  for (std::atomic<Crew*>& place : kept) {
    Crew* const crew = place.exchange(nullptr);
    if (crew == nullptr) continue;
    if (crew->workers() == workers && crew->choice() == choice) {
      crew->use(workers);
      return crew;
    }
    keep(crew);
  }
  return nullptr;
}

}  // namespace

[[gnu::cold]] std::shared_ptr<Crew> make_crew(std::shared_ptr<Executor> executor, unsigned threads) {
  const auto choice = threads == 0 ? Crew::Choice::by_gain : Crew::Choice::given;
  const unsigned there = executor ? std::max(1U, executor->concurrency()) : machine_threads();
  const unsigned most = threads == 0 ? tuning::kMostWorkers : threads;
  const unsigned workers = executor || threads == 0 ? std::min(most, there) : threads;
  const bool may_keep = !executor && workers > 1;
  Crew* crew = may_keep ? take_kept(workers, choice) : nullptr;
  if (crew == nullptr) {
    if (!executor) executor = std::make_shared<ThreadPool>(workers);
    crew = new Crew(std::move(executor), workers, choice);
  }
  return {crew, may_keep ? keep : [](Crew* given_up) { delete given_up; }};
}

}  // namespace cellsweep
