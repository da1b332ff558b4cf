/// @file
/// The program of the suite of one-shot searches: Google Benchmark's options and, by default, three
/// repetitions in random order, median and spread, also in out/one-shot.json unless rows are chosen.
/// `--quick`, as the first argument, searches 1,000 boxes, once. Before a row is timed its pairs are compared
/// with those of the first one.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "bench/context.h"
#include "bench/one_shot/box_sets.h"

namespace cellsweep::bench {
namespace {

struct Row {
  std::string scene;
  std::string kind;
  std::size_t boxes;
};

/// The sets of the last row asked for: rows of the same ones follow each other, or take their turns.
const BoxSets& sets_of(const Row& row) {
  static std::map<std::string, BoxSets> sets;
  const std::string name = row.scene + "/" + row.kind + "/" + std::to_string(row.boxes);
  const auto found = sets.find(name);
  if (found != sets.end()) return found->second;
  return sets[name] = make_box_sets(row.scene, row.kind, row.boxes);
}

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

void run_row(benchmark::State& state, const Row& row, const SearcherInfo& info) {
  const BoxSets& sets = sets_of(row);
  const Found truth = search(own_searchers().front(), sets);
  const Found found = search(info, sets);
  if (found.count != truth.count || (info.lists && found.hash != truth.hash))
    return state.SkipWithError("other pairs than those of the first row");
  const auto searcher = info.make();
  for (auto _ : state) searcher->find(sets);
  state.counters["pairs"] = static_cast<double>(found.count);
  state.SetLabel(hash_text(truth.hash));
}

void register_rows(std::span<const std::size_t> numbers, std::span<const SearcherInfo> searchers) {
  for (const std::string_view scene : kSetScenes) {
    for (const std::string_view kind : kSetKinds) {
      for (const std::size_t boxes : numbers) {
        for (const SearcherInfo& info : searchers) {
          if (kind == "one" && !info.takes_one_set) continue;
          const Row row{std::string(scene), std::string(kind), boxes};
          const std::string name = "one_shot/" + row.scene + "/" + row.kind + "/" + std::to_string(boxes) +
                                   "/" + std::string(info.name);
          benchmark::RegisterBenchmark(name.c_str(),
                                       [row, &info](benchmark::State& state) { run_row(state, row, info); })
              ->Unit(benchmark::kMillisecond)
              ->UseRealTime();
        }
      }
    }
  }
}

bool runs_all(int argc, char** argv) {
  return std::none_of(argv + 1, argv + argc, [](std::string_view argument) {
    return argument.starts_with("--benchmark_filter") || argument.starts_with("--benchmark_list_tests");
  });
}

}  // namespace
}  // namespace cellsweep::bench

int main(int argc, char** argv) {
  using namespace cellsweep::bench;
  const bool quick = argc > 1 && std::string_view(argv[1]) == "--quick";
  std::vector<std::string> defaults = {"--benchmark_report_aggregates_only=true"};
  if (!quick) defaults.emplace_back("--benchmark_repetitions=3");
  if (!quick) defaults.emplace_back("--benchmark_enable_random_interleaving=true");
  if (!quick && runs_all(argc, argv)) defaults.emplace_back("--benchmark_out=out/one-shot.json");
  std::error_code ignored;  // Google Benchmark says when it cannot write there
  std::filesystem::create_directories("out", ignored);
  std::vector<char*> arguments = {argv[0]};
  for (std::string& option : defaults) arguments.push_back(option.data());
  arguments.insert(arguments.end(), argv + (quick ? 2 : 1), argv + argc);
  int count = static_cast<int>(arguments.size());

  add_context();
  const std::vector<std::size_t> numbers =
      quick ? std::vector<std::size_t>{1'000} : std::vector<std::size_t>{10'000, 100'000, 1'000'000};
  register_rows(numbers, own_searchers());
#ifdef CELLSWEEP_PEER_CGAL
  register_rows(numbers, cgal_searchers());
#endif
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
