#include "engines/stream/stream.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "broadphase/text.h"
#include "engines/phase_timer.h"

namespace cellsweep::stream {
namespace {

using Clock = std::chrono::steady_clock;

/// More threads than this were never measured.
constexpr unsigned kMostWorkers = 16;

// First guesses, in seconds; every update measures.
constexpr double kFullGuess = 80e-9;
constexpr double kPartialGuess = 200e-9;
constexpr double kMoveGuess = 4e-9;
constexpr double kTestGuess = 5e-9;
/// The share of changed bodies at which everything is found anew lies between these, whatever was measured.
constexpr double kLeastShare = 0.1;
constexpr double kMostShare = 0.5;
/// Work worth less than this on one thread is not worth asking what a dispatch takes.
constexpr double kTooSmall = 100e-6;
/// Not even when asked for does a worker get less to do than this.
constexpr std::size_t kLeastItems = 16;
/// A frame has about so many jobs for the pool.
constexpr double kJobs = 8;

unsigned workers_for(unsigned threads) {
  if (threads != 0) return threads;
  return std::clamp(std::thread::hardware_concurrency(), 1U, kMostWorkers);
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

// One late thread must not change a plan.
void Stream::Cost::learn(double sample) {
  seconds += 0.25 * (std::clamp(sample, seconds / 4, seconds * 2) - seconds);
}

Stream::Stream(unsigned threads, const Kernels& kernels)
    : threads_are_given_(threads != 0),
      kernels_(kernels),
      pool_(workers_for(threads)),
      tree_(pool_, kernels),
      full_cost_{kFullGuess},
      partial_cost_{kPartialGuess} {
  refresh_counters();
}

Capacity Stream::capacity() const {
  return {kSlotMask, "", text("a slot's number has ", kSlotBits, " bits")};
}

Status Stream::insert(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  return bodies_.insert(ids, boxes);
}

Status Stream::move(std::span<const BodyId> ids, std::span<const Aabb> boxes) {
  choose_workers(ids.size(), kMoveGuess);
  return bodies_.move(pool_, ids, boxes);
}

Status Stream::remove(std::span<const BodyId> ids) {
  return bodies_.remove(ids);
}

// All workers, when they are asked for or save several times what waking them costs; else the caller alone.
void Stream::choose_workers(std::size_t items, double seconds_of_item) {
  if (threads_are_given_) return pool_.use(items / kLeastItems >= pool_.workers() ? pool_.workers() : 1);
  const double seconds_of_one = static_cast<double>(items) * seconds_of_item;
  pool_.use(1);
  if (seconds_of_one < kTooSmall || pool_.workers() == 1) return;
  const double saved = seconds_of_one * (1 - 1.0 / pool_.workers());
  if (saved > 2 * kJobs * pool_.seconds_to_dispatch()) pool_.use(pool_.workers());
}

Stream::Kind Stream::kind_of_update() {
  if (bodies_.is_settled()) return kIdle;
  if (bodies_.too_many()) return kFull;
  return bodies_.changes().empty() ? kInPlace : kPartial;
}

Result<PairChanges> Stream::update() {
  PhaseTimer timer(statistics_.phases);
  PairChanges changes;
  const Kind kind = kind_of_update();
  if (kind != kIdle) {
    try {
      changes = update_pairs(kind);
    } catch (...) {  // out of memory in the midst of it: the next update starts anew
      bodies_.give_up_listing();
      throw;
    }
    bodies_.settle();
    plan_ahead();
  }
  ++updates_[kind];
  ++statistics_.updates;
  timer.lap("find pairs");
  if (kind != kIdle) refresh_counters();
  statistics_.counters[kind].value = updates_[kind];
  return changes;
}

PairChanges Stream::update_pairs(Kind kind) {
  if (hulls_are_boxes_ && bodies_.has_slack()) {
    pairs_.copy(candidates_.pairs());
    hulls_are_boxes_ = false;
  }
  PairChanges changes;
  if (kind == kFull) changes = update_all();
  if (kind == kPartial) changes = update_changed();
  if (hulls_are_boxes_) return changes;
  const std::span<const Pair> candidates = candidates_.pairs();
  choose_workers(candidates.size(), kTestGuess);
  return pairs_.keep_overlapping(pool_, candidates, bodies_.boxes(), bodies_.table());
}

PairChanges Stream::update_all() {
  bodies_.tidy();
  const double count = static_cast<double>(std::max<std::size_t>(bodies_.size(), 1));
  choose_workers(bodies_.size(), full_cost_.seconds);
  const Clock::time_point start = Clock::now();
  tree_.build(bodies_.hulls(), bodies_.table().ids());
  built_copies_ = tree_.copies();
  changed_ += bodies_.size();
  const PairChanges changes = candidates_.replace(pool_, tree_.found());
  full_cost_.learn(seconds_since(start) * pool_.active() / count);
  return changes;
}

PairChanges Stream::update_changed() {
  const std::span<const Change> changed = bodies_.changes();
  const double count = static_cast<double>(changed.size());
  choose_workers(changed.size(), partial_cost_.seconds);
  const Clock::time_point start = Clock::now();
  tree_.change(changed, bodies_.table().ids());
  changed_ += changed.size();
  const PairChanges changes = candidates_.change(pool_, tree_.began(), tree_.ended());
  partial_cost_.learn(seconds_since(start) * pool_.active() / count);
  return changes;
}

// Up to how many changes the next update would rather look at one by one. Cells wear out: boxes that enter
// leave gaps in memory behind and crowd cells.
void Stream::plan_ahead() {
  const double count = static_cast<double>(bodies_.size());
  const bool worn_out = tree_.copies() > 2 * built_copies_ + 1024;
  const double most = count * std::clamp(full_cost_.seconds / partial_cost_.seconds, kLeastShare, kMostShare);
  bodies_.list_changes(worn_out ? 0 : static_cast<std::size_t>(most));
}

void Stream::refresh_counters() {
  statistics_.counters.assign(
      {{"full updates", updates_[kFull]},
       {"partial updates", updates_[kPartial]},
       {"in-place updates", updates_[kInPlace]},
       {"idle updates", updates_[kIdle]},
       {"hulls put into cells", changed_},
       {"candidates", candidates_.pairs().size()},
       {"pieces", tree_.pieces()},
       {"boxes in cells", tree_.copies()},
       {"workers", pool_.active()},
       {"vector lanes", kernels_.lanes},
       {"bytes", bodies_.bytes() + tree_.bytes() + candidates_.bytes() + pairs_.bytes()}});
}

}  // namespace cellsweep::stream

namespace cellsweep {

Result<std::unique_ptr<Broadphase>> make_stream(const EngineOptions& options) {
  const stream::Kernels* kernels = stream::find_kernels(options.isa);
  if (kernels == nullptr) {
    return Status{
        StatusCode::bad_option,
        "This machine or build does not have the instruction set that isa names; leave the choice to "
        "the engine.",
        std::nullopt,
        static_cast<std::uint64_t>(options.isa),
        0,
        "isa"};
  }
  return std::unique_ptr<Broadphase>(std::make_unique<stream::Stream>(options.threads, *kernels));
}

}  // namespace cellsweep
