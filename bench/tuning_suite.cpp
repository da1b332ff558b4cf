#include "bench/tuning_suite.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "base/crew.h"
#include "base/pair_sort.h"
#include "base/thread_pool.h"
#include "base/tuning.h"
#include "cellsweep/broadphase.h"
#include "cellsweep/world/scene.h"
#include "engines/stream/cells/keys.h"
#include "engines/stream/kernels/kernel.h"
#include "report/hand_over.h"

namespace cellsweep::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_of(const std::function<void()>& work) {
  const Clock::time_point start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::unique_ptr<FrameSource> uniform(std::size_t bodies, double moving) {
  return std::move(*make_scene_frames({.scene = "uniform", .bodies = bodies, .moving = moving}));
}

Broadphase one_thread() {
  return std::move(*make_broadphase(StreamOptions{.threads = 1}));
}

std::uint64_t counter_of(const Broadphase& broadphase, std::size_t place) {
  return broadphase.statistics().counters[place].value;
}

double seconds_of_phase(const Broadphase& broadphase, std::string_view name) {
  for (const Phase& phase : broadphase.statistics().phases) {
    if (phase.name == name) return phase.milliseconds / 1000;
  }
  return 0;
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

/// Seconds for one changed fat box, and for the test of one candidate, while some bodies move.
struct ChangeCosts {
  double change = 0;
  double test = 0;
};
ChangeCosts change_costs() {
  constexpr std::size_t kFatBoxes = 4;  // of the counters: put into cells
  constexpr std::size_t kCandidates = 5;
  const auto source = uniform(10'000, 0.05);
  Broadphase broadphase = one_thread();
  if (!report::insert_all(broadphase, *source).ok() || !broadphase.update()) return {};
  ChangeCosts sum;
  double changed = 0, tested = 0;
  for (int frame = 0; frame < 40 && source->advance(); ++frame) {
    const std::uint64_t before = counter_of(broadphase, kFatBoxes);
    if (!report::move_changed(broadphase, *source).ok() || !broadphase.update()) return {};
    sum.change += seconds_of_phase(broadphase, "cells") + seconds_of_phase(broadphase, "candidates");
    sum.test += seconds_of_phase(broadphase, "tests");
    changed += static_cast<double>(counter_of(broadphase, kFatBoxes) - before);
    tested += static_cast<double>(counter_of(broadphase, kCandidates));
  }
  return {sum.change / std::max(changed, 1.0), sum.test / std::max(tested, 1.0)};
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
      kernels.all_pairs(cell, found.buffer());
    }
  });
  return 1e9 * seconds / kTimes / (kBoxes * (kBoxes - 1) / 2.0);
}

/// Nanoseconds to put one copy of a box into a cell: what is left of building cells without the comparisons.
double copy_cost() {
  constexpr std::size_t kCopies = 7;  // of the counters: boxes in cells
  const auto source = uniform(100'000, 0);
  Broadphase broadphase = one_thread();
  if (!report::insert_all(broadphase, *source).ok() || !broadphase.update()) return 0;
  return 1e9 * seconds_of_phase(broadphase, "cells") / static_cast<double>(counter_of(broadphase, kCopies));
}

/// Seconds until threads that were not there have done their first job, and to hand them another one.
struct ThreadCosts {
  double start = 0;
  double dispatch = 0;
};
ThreadCosts thread_costs() {
  const unsigned threads = std::clamp(machine_threads(), 2U, tuning::kMostWorkers);
  ThreadPool pool(threads);
  const auto nothing = [](void*, unsigned) {};
  const double start = seconds_of([&] { pool.run(threads, nothing, nullptr); });
  return {start, seconds_of([&] { pool.run(threads, nothing, nullptr); })};
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

void register_row(const std::string& name, double in_code, const std::function<double()>& measure) {
  benchmark::RegisterBenchmark(("tuning/" + name).c_str(),
                               [=](benchmark::State& state) {
                                 double measured = 0;
                                 for (auto _ : state) {
                                   measured = measure();
                                   state.SetIterationTime(1e-3);
                                 }
                                 state.counters["measured"] = measured;
                                 state.counters["in_code"] = in_code;
                               })
      ->UseManualTime()
      ->Iterations(3);
}

}  // namespace

void register_tuning_suite() {
  register_row("kMoveGuess", tuning::kMoveGuess, move_cost);
  register_row("kFullGuess", tuning::kFullGuess, full_cost);
  register_row("kPartialGuess", tuning::kPartialGuess, [] { return change_costs().change; });
  register_row("kTestGuess", tuning::kTestGuess, [] { return change_costs().test; });
  register_row("kTestCost", tuning::kTestCost, test_cost);
  register_row("kCopyCost", tuning::kCopyCost, copy_cost);
  register_row("kStartCost", tuning::kStartCost, [] { return thread_costs().start; });
  register_row("kTooSmall", tuning::kTooSmall, [] { return 2 * tuning::kJobs * thread_costs().dispatch; });
  // Nanoseconds of a pair just below and above where the way to sort changes; neither should stand out.
  for (const std::size_t limit : {tuning::kFewKeys, tuning::kOneBucket, tuning::kOneCount}) {
    register_row("sort/" + std::to_string(limit), 0, [limit] { return sort_cost(limit); });
    register_row("sort/" + std::to_string(limit + 1), 0, [limit] { return sort_cost(limit + 1); });
  }
}

}  // namespace cellsweep::bench
