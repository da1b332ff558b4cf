#include <benchmark/benchmark.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "base/sorting/key_sort.h"
#include "base/sorting/pair_sort.h"
#include "base/threads/crew.h"
#include "base/threads/thread_pool.h"
#include "base/tuning.h"
#include "bench/tuning/rows.h"
#include "broadphase/bodies/id_table.h"
#include "cellsweep/broadphase.h"
#include "engines/stream/kernels/kernel.h"
#include "engines/stream/pairs/candidate_list.h"
#include "engines/stream/pairs/overlap_marks.h"
#include "report/hand_over.h"

namespace cellsweep::bench {
namespace {

Broadphase one_thread() {
  return std::move(*make_broadphase(StreamOptions{.threads = 1}));
}

/// Seconds to check and remember one new body, all in one call.
double insert_cost() {
  constexpr std::size_t kBodies = 100'000;
  const auto source = uniform(kBodies, 0);
  Broadphase broadphase = one_thread();
  std::vector<BodyId> ids(kBodies);
  std::iota(ids.begin(), ids.end(), BodyId{0});
  return seconds_of([&] { benchmark::DoNotOptimize(broadphase.insert(ids, source->boxes()).ok()); }) /
         kBodies;
}

/// Seconds to check and remember one move, all bodies in one call.
double move_cost() {
  constexpr std::size_t kBodies = 100'000;
  const auto source = uniform(kBodies, 1);
  Broadphase broadphase = one_thread();
  if (!report::insert_all(broadphase, *source).ok() || !broadphase.update()) return 0;
  source->advance();
  std::vector<BodyId> ids(kBodies);
  std::iota(ids.begin(), ids.end(), BodyId{0});
  return seconds_of([&] { benchmark::DoNotOptimize(broadphase.move(ids, source->boxes())); }) / kBodies;
}

/// Seconds for one body when all are new.
double full_cost() {
  constexpr std::size_t kBodies = 10'000;
  const auto source = uniform(kBodies, 0);
  Broadphase broadphase = one_thread();
  if (!report::insert_all(broadphase, *source).ok()) return 0;
  return seconds_of([&] { benchmark::DoNotOptimize(broadphase.update().ok()); }) / kBodies;
}

/// Seconds for one changed fat box, of a twentieth that change.
double change_cost() {
  constexpr std::size_t kBodies = 10'000;
  const auto source = uniform(kBodies, 1);
  Cells cells;
  cells.build_seconds(source->boxes());
  const std::vector<Aabb> before(source->boxes().begin(), source->boxes().end());
  source->advance();
  std::vector<stream::FatBoxChange> changes;
  for (Slot slot = 0; slot < kBodies; slot += 20)
    changes.push_back({slot, true, true, before[slot], source->boxes()[slot]});
  return seconds_of([&] { cells.tree.change(changes); }) / static_cast<double>(changes.size());
}

/// Seconds for the test of one candidate whose boxes are far from each other.
double candidate_cost() {
  const auto source = uniform(100'000, 1);
  Cells cells;
  cells.build_seconds(source->boxes());
  stream::CandidateList candidates;
  candidates.replace(cells.tree.found());
  stream::PairRoom room;
  const std::span<const SlotPair> pairs = candidates.pairs(cells.crew, room);
  stream::OverlapMarks marks;
  const auto* boxes = source->boxes().data();
  return seconds_of([&] { marks.test_all(cells.crew, pairs, boxes); }) / static_cast<double>(pairs.size());
}

/// Nanoseconds to compare a box of a cell with another one, by the best kernels.
double test_cost() {
  constexpr std::uint32_t kBoxes = 128;
  const stream::Kernels& kernels = *stream::find_kernels(VectorIsa::best);
  const auto source = uniform(kBoxes, 0);
  std::vector<stream::TaggedBox> boxes(kBoxes);
  for (std::uint32_t i = 0; i < kBoxes; ++i)
    boxes[i] = {source->boxes()[i], i | stream::kWholeFlags << kSlotBits, 0};
  const stream::CellBoxes cell{boxes.data(), kBoxes, kBoxes};
  stream::Keys found;
  constexpr int kTimes = 1000;
  const double seconds = seconds_of([&] {
    for (int i = 0; i < kTimes; ++i) {
      found.clear();
      kernels.all_pairs(cell, cell.count, found.buffer());
    }
  });
  return 1e9 * seconds / kTimes / (kBoxes * (kBoxes - 1) / 2.0);
}

/// Nanoseconds to put one copy of a box into a cell, with the comparisons there: an upper bound.
double copy_cost() {
  const auto source = uniform(100'000, 1);
  Cells cells;
  cells.build_seconds(source->boxes());
  return 1e9 * cells.build_seconds(source->boxes()) / static_cast<double>(cells.tree.copies());
}

/// Seconds until threads that were not there have done their first job, and to hand them another one.
struct ThreadCosts {
  double start = 0;
  double dispatch = 0;
};

/// Tasks that end when all have begun, or after a while: an executor may run one after the other.
struct Meeting {
  using Clock = std::chrono::steady_clock;
  unsigned tasks;
  std::atomic<unsigned> begun = 0;
  Clock::time_point end = Clock::now() + std::chrono::milliseconds(10);

  static void attend(void* of, unsigned) {
    auto& meeting = *static_cast<Meeting*>(of);
    ++meeting.begun;
    while (meeting.begun < meeting.tasks && Clock::now() < meeting.end) continue;
  }
};

ThreadCosts thread_costs() {
  const unsigned threads = std::clamp(machine_threads(), 2U, tuning::kMostWorkers);
  ThreadPool pool(threads);
  const auto meet = [&] {
    Meeting meeting{threads};
    pool.run(threads, Meeting::attend, &meeting);
  };
  const double start = seconds_of(meet);
  return {start, seconds_of(meet)};
}

/// Nanoseconds to sort one pair of so many, with first numbers below as many.
double sort_cost(std::size_t pairs) {
  std::mt19937_64 random(1);
  std::vector<std::uint64_t> keys(pairs);
  for (auto& key : keys) key = (random() % pairs) << 32 | (random() >> 32);
  Crew crew(nullptr, 1, Crew::Choice::given);
  Array<std::uint64_t> scratch;
  Array<SlotPair> sorted;
  const std::span<const std::uint64_t> part = keys;
  return 1e9 * seconds_of([&] {
           sort_pairs(crew, {&part, 1}, scratch, sorted);
         }) /
         static_cast<double>(pairs);
}

/// Nanoseconds to sort one key of so many bits.
double key_cost(unsigned bits) {
  constexpr std::size_t kKeys = 10'000;
  std::mt19937_64 random(1);
  std::vector<std::uint64_t> keys(kKeys), spare(kKeys);
  for (auto& key : keys) key = random() >> (64 - bits);
  return 1e9 * seconds_of([&] { sort_keys(keys, spare); }) / kKeys;
}

/// Nanoseconds to give a slot to one id of so many from anywhere.
double id_cost(std::size_t count) {
  std::mt19937 random(1);
  std::vector<BodyId> ids(count);
  std::generate(ids.begin(), ids.end(), std::ref(random));
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  std::shuffle(ids.begin(), ids.end(), random);
  return 1e9 *
         quickest_seconds_of(20,
                             [&] {
                               IdTable table;
                               List<Slot> slots;
                               if (!table.insert(ids, slots)) std::abort();
                             }) /
         static_cast<double>(ids.size());
}

/// The counter `measured` is in the unit of the constant that the row is named after.
void register_row(const std::string& name, double in_code, const std::function<double()>& measure) {
  register_tuning_row(name, [=] { return Measured{{"measured", measure()}, {"in_code", in_code}}; });
}

}  // namespace

void register_cost_rows() {
  register_row("kInsertGuess", tuning::kInsertGuess, insert_cost);
  register_row("kMoveGuess", tuning::kMoveGuess, move_cost);
  register_row("kFullGuess", tuning::kFullGuess, full_cost);
  register_row("kPartialGuess", tuning::kPartialGuess, change_cost);
  register_row("kTestGuess", tuning::kTestGuess, candidate_cost);
  register_row("kTestCost", tuning::kTestCost, test_cost);
  register_row("kCopyCost", tuning::kCopyCost, copy_cost);
  register_row("kStartCost", tuning::kStartCost, [] { return thread_costs().start; });
  register_row("kTooSmall", tuning::kTooSmall, [] { return 2 * tuning::kJobs * thread_costs().dispatch; });
  // Nanoseconds of a pair just below and above where the way to sort changes; neither should stand out.
  for (const std::size_t limit : {tuning::kFewKeys, tuning::kOneStep}) {
    register_row("sort/" + std::to_string(limit), 0, [limit] { return sort_cost(limit); });
    register_row("sort/" + std::to_string(limit + 1), 0, [limit] { return sort_cost(limit + 1); });
  }
  for (const unsigned bits : {11 * tuning::kFewDigits, 11 * tuning::kFewDigits + 1}) {
    register_row("keys/" + std::to_string(bits) + "-bits", 0, [bits] { return key_cost(bits); });
  }
  for (const std::size_t ids :
       {tuning::kTableWaits / 2, tuning::kTableWaits - 1, tuning::kTableWaits + 1, 2 * tuning::kTableWaits}) {
    register_row("ids/" + std::to_string(ids), 0, [ids] { return id_cost(ids); });
  }
}

}  // namespace cellsweep::bench
