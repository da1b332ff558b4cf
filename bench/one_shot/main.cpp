/// @file
/// The program of the suite of one-shot searches: Google Benchmark's options. Those that are compared take
/// turns, so that each row comes three times; all go into out/one-shot/one-shot.json, too, unless rows are
/// chosen. `--quick`, as the first argument, searches 1,000 boxes, once. Before a row is timed its pairs are
/// compared with those of the first one.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text.h"
#include "bench/one_shot/box_sets.h"
#include "bench/run_rows.h"

namespace cellsweep::bench {
namespace {

struct Row {
  std::string scene;
  std::string kind;
  std::size_t boxes = 0;

  friend bool operator==(const Row&, const Row&) = default;
};

std::uint64_t hash_of(std::vector<CrossPair> pairs) {
  std::sort(pairs.begin(), pairs.end());
  std::uint64_t hash = pairs.size();
  for (const CrossPair& pair : pairs) hash = mix64(hash ^ (std::uint64_t{pair.a} << 32 | pair.b));
  return hash;
}

struct Found {
  std::size_t count = 0;
  std::uint64_t hash = 0;
};

Found search(const SearcherInfo& info, const BoxSets& sets) {
  const auto searcher = info.make();
  searcher->find(sets);
  std::vector<CrossPair> pairs;
  searcher->list(pairs);
  return {searcher->count(), hash_of(std::move(pairs))};
}

/// The sets of a row, and what has been found in them.
class Stage {
 public:
  explicit Stage(const Row& row)
      : row_(row),
        sets_(make_box_sets(row.scene, row.kind, row.boxes)),
        truth_(search(own_searchers().front(), sets_)) {}

  bool is_of(const Row& row) const { return row_ == row; }
  const BoxSets& sets() const { return sets_; }
  const Found& truth() const { return truth_; }

  /// Whether a search finds what the first one does; it is tried once.
  bool is_right(const SearcherInfo& info) {
    const auto [entry, is_new] = right_.try_emplace(info.name, false);
    if (is_new) {
      const Found found = search(info, sets_);
      entry->second = found.count == truth_.count && (!info.lists || found.hash == truth_.hash);
    }
    return entry->second;
  }

 private:
  Row row_;
  BoxSets sets_;
  Found truth_;
  std::map<std::string_view, bool> right_;
};

/// Of the row asked for last: rows of the same sets follow each other.
Stage& stage_of(const Row& row) {
  static std::optional<Stage> stage;
  if (!stage || !stage->is_of(row)) stage.emplace(row);
  return *stage;
}

void run_row(benchmark::State& state, const Row& row, const SearcherInfo& info) {
  Stage& stage = stage_of(row);
  if (!stage.is_right(info)) return state.SkipWithError("other pairs than those of the first row");
  const auto searcher = info.make();
  for (auto _ : state) searcher->find(stage.sets());
  state.counters["pairs"] = static_cast<double>(stage.truth().count);
  state.SetLabel(hash_text(stage.truth().hash));
}

void register_row(const Row& row, const SearcherInfo& info) {
  const std::string name = text("one_shot/", row.scene, "/", row.kind, "/", row.boxes, "/", info.name);
  benchmark::RegisterBenchmark(name.c_str(),
                               [row, &info](benchmark::State& state) { run_row(state, row, info); })
      ->Unit(benchmark::kMillisecond)
      ->UseRealTime();
}

/// How much is searched, and how often those that are compared take turns.
struct Amount {
  std::vector<std::size_t> boxes = {10'000, 100'000, 1'000'000};
  std::size_t turns = 3;
};

// Those that are compared are timed within seconds: a machine that others share takes half as long again for
// minutes at a time.
void register_cell(const Row& row, std::span<const SearcherInfo> searchers, std::size_t turns) {
  for (std::size_t turn = 0; turn < turns; ++turn) {
    for (const SearcherInfo& info : searchers) {
      if (row.kind != "one" || info.takes_one_set) register_row(row, info);
    }
  }
}

std::vector<SearcherInfo> all_searchers() {
  std::vector<SearcherInfo> all(own_searchers().begin(), own_searchers().end());
#ifdef CELLSWEEP_PEER_CGAL
  all.insert(all.end(), cgal_searchers().begin(), cgal_searchers().end());
#endif
  return all;
}

void register_rows(const Amount& amount, std::span<const SearcherInfo> searchers) {
  for (const std::string_view scene : kSetScenes) {
    for (const std::string_view kind : kSetKinds) {
      for (const std::size_t boxes : amount.boxes)
        register_cell({std::string(scene), std::string(kind), boxes}, searchers, amount.turns);
    }
  }
}

}  // namespace
}  // namespace cellsweep::bench

int main(int argc, char** argv) {
  using namespace cellsweep::bench;
  const bool quick = argc > 1 && std::string_view(argv[1]) == "--quick";
  if (quick) {
    argv[1] = argv[0];
    ++argv;
    --argc;
  }
  const std::vector<SearcherInfo> searchers = all_searchers();
  register_rows(quick ? Amount{{1'000}, 1} : Amount{}, searchers);
  return run_rows(argc, argv, {}, quick ? "" : "out/one-shot/one-shot.json");
}
