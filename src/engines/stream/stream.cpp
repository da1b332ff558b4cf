#include "engines/stream/stream.h"

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "base/text.h"
#include "cellsweep/engine/phase_timer.h"

namespace cellsweep::stream {
namespace {

using Clock = std::chrono::steady_clock;

/// More threads than this were never measured.
constexpr unsigned kMostWorkers = 16;

// First guesses, in seconds; every update measures.
constexpr double kFullGuess = 50e-9;
constexpr double kPartialGuess = 200e-9;
constexpr double kMoveGuess = 4e-9;
constexpr double kTestGuess = 4e-9;
/// The share of changed bodies at which everything is found anew lies between these, whatever was measured.
constexpr double kLeastShare = 0.1;
constexpr double kMostShare = 0.5;
/// Work worth less than this on one thread is not worth asking what a dispatch takes.
constexpr double kTooSmall = 100e-6;
/// What starting threads takes, roughly, until they have done their first job.
constexpr double kStartCost = 300e-6;
/// When no more than one in so many bodies got a new box, candidates of two others are not tested.
constexpr std::size_t kFewFresh = 20;
/// So many candidates and twice the pairs allowed are always looked at.
constexpr std::size_t kFewCandidates = 1000;
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

Stream::Stream(unsigned threads, std::uint64_t max_pairs, const Kernels& kernels,
               std::unique_ptr<PieceFinder> finder)
    : threads_are_given_(threads != 0),
      kernels_(kernels),
      max_pairs_(max_pairs == 0 ? kAnyNumber : static_cast<std::size_t>(max_pairs)),
      finder_(std::move(finder)),
      pool_(workers_for(threads)),
      tree_(pool_, kernels, finder_.get()),
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
// Threads are started when they would have saved by now what that costs.
void Stream::choose_workers(std::size_t items, double seconds_of_item) {
  if (threads_are_given_) return pool_.use(items / kLeastItems >= pool_.workers() ? pool_.workers() : 1);
  const double seconds_of_one = static_cast<double>(items) * seconds_of_item;
  pool_.use(1);
  if (seconds_of_one < kTooSmall || pool_.workers() == 1) return;
  const double saved = seconds_of_one * (1 - 1.0 / pool_.workers());
  missed_ += saved;
  if (missed_ < kStartCost) return;
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
  Kind kind = kind_of_update();
  if (kind != kIdle) {
    try {
      changes = update_or_start_anew(kind);
    } catch (const TooManyPairs&) {
      bodies_.give_up_listing();
      return too_many_pairs();
    } catch (PieceFailure& failure) {
      bodies_.give_up_listing();
      return std::move(failure.status);
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

Status Stream::too_many_pairs() const {
  return {StatusCode::capacity,
          text("There are more than ", max_pairs_,
               " pairs, the most that max_pairs allows; raise it, or set it to 0."),
          std::nullopt,
          max_pairs_ + 1,
          max_pairs_,
          "max_pairs"};
}

// Too many candidates among the few that changed are no reason to refuse: all of them may have become too
// many.
PairChanges Stream::update_or_start_anew(Kind& kind) {
  if (kind == kPartial) {
    try {
      return update_pairs(kind);
    } catch (const TooManyPairs&) {
      bodies_.give_up_listing();
      kind = kFull;
    }
  }
  return update_pairs(kind);
}

PairChanges Stream::update_pairs(Kind kind) {
  if (hulls_are_boxes_ && bodies_.has_slack()) {
    pairs_.start(candidates_.pairs());
    hulls_are_boxes_ = false;
  }
  PairChanges changes;
  if (kind == kFull) changes = update_all();
  if (kind == kPartial) changes = update_changed();
  return hulls_are_boxes_ ? changes : test_candidates(kind, changes);
}

PairChanges Stream::test_candidates(Kind kind, const PairChanges& of_candidates) {
  const std::span<const Pair> candidates = candidates_.pairs();
  choose_workers(candidates.size(), kTestGuess);
  TestedBoxes tested{bodies_.boxes().data(), bodies_.table()};
  if (kind == kFull) return pairs_.renew(pool_, candidates, tested, max_pairs_);
  if (bodies_.fresh() < bodies_.size() / kFewFresh) {
    tested.stamps = bodies_.stamps();
    tested.is_new = bodies_.stamp();
  }
  return pairs_.refresh(pool_, candidates, of_candidates, tested, max_pairs_);
}

PairChanges Stream::update_all() {
  bodies_.tidy();
  const double count = static_cast<double>(std::max<std::size_t>(bodies_.size(), 1));
  choose_workers(bodies_.size(), full_cost_.seconds);
  const Clock::time_point start = Clock::now();
  build_tree();
  built_copies_ = tree_.copies();
  changed_ += bodies_.size();
  const PairChanges changes =
      candidates_.replace(pool_, tree_.found(), hulls_are_boxes_ ? max_pairs_ : kAnyNumber);
  full_cost_.learn(seconds_since(start) * pool_.active() / count);
  return changes;
}

// Hulls that overlap are no reason to refuse, but when there are very many, boxes are put in their place.
void Stream::build_tree() {
  const std::size_t generous = max_pairs_ < kAnyNumber / 4 ? 2 * max_pairs_ + kFewCandidates : kAnyNumber;
  if (bodies_.has_slack()) {
    tree_.limit_pairs(generous);
    try {
      return tree_.build(bodies_.hulls(), bodies_.table().ids());
    } catch (const TooManyPairs&) {
      bodies_.drop_hulls();
    }
  }
  tree_.limit_pairs(max_pairs_);
  tree_.build(bodies_.hulls(), bodies_.table().ids());
  tree_.limit_pairs(generous);
}

PairChanges Stream::update_changed() {
  const std::span<const Change> changed = bodies_.changes();
  const double count = static_cast<double>(changed.size());
  choose_workers(changed.size(), partial_cost_.seconds);
  const Clock::time_point start = Clock::now();
  tree_.change(changed, bodies_.table().ids());
  changed_ += changed.size();
  const PairChanges changes =
      candidates_.change(pool_, tree_.began(), tree_.ended(), hulls_are_boxes_ ? max_pairs_ : kAnyNumber);
  partial_cost_.learn(seconds_since(start) * pool_.active() / count);
  return changes;
}

// Up to how many changes the next update would rather look at one by one. Cells wear out: boxes that enter
// leave gaps in memory behind and crowd cells.
void Stream::plan_ahead() {
  const double count = static_cast<double>(bodies_.size());
  const bool worn_out = tree_.copies() > 2 * built_copies_ + 1024;
  const double most = count * std::clamp(full_cost_.seconds / partial_cost_.seconds, kLeastShare, kMostShare);
  bodies_.list_changes(worn_out || finder_ != nullptr ? 0 : static_cast<std::size_t>(most));
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
  if (finder_ == nullptr) return;
  finder_->add_counters(statistics_.counters);
  statistics_.cell = finder_->take_cell_time();
}

}  // namespace cellsweep::stream

namespace cellsweep {

Result<std::unique_ptr<Broadphase>> make_stream(const EngineOptions& options,
                                                std::unique_ptr<stream::PieceFinder> finder) {
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
  return std::unique_ptr<Broadphase>(
      std::make_unique<stream::Stream>(options.threads, options.max_pairs, *kernels, std::move(finder)));
}

}  // namespace cellsweep
