/// @file
/// The program of the suite of peers: Google Benchmark's options and, by default, up to 100,000 bodies. Peers
/// that are compared take turns, so that each row comes several times; all go into out/peers/peers.json, too,
/// unless rows are chosen. `--notes` prints how to read the rows; `--giant first|middle|last`, as the first
/// argument, puts a giant into every scene, and the results into out/peers/giant-SLOT.json.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "bench/context.h"
#include "bench/peers/few_suite.h"
#include "bench/peers/peer_suite.h"
#include "bench/peers/peer_table.h"
#include "bench/peers/tail_suite.h"

namespace {

// A few rows, or a list of them, do not take the place of a quarter of an hour's results.
bool runs_the_whole_suite(int argc, char** argv) {
  return std::none_of(argv + 1, argv + argc, [](std::string_view argument) {
    return argument.starts_with("--benchmark_filter") || argument.starts_with("--benchmark_list_tests");
  });
}

// Options given later win, so defaults go in front of the caller's.
std::vector<char*> with_defaults(int argc, char** argv, const std::string& out) {
  static std::vector<std::string> defaults = {"--benchmark_filter=/(1000|10000|100000)/"};
  if (runs_the_whole_suite(argc, argv)) defaults.emplace_back("--benchmark_out=" + out);
  std::vector<char*> arguments = {argv[0]};
  for (std::string& option : defaults) arguments.push_back(option.data());
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  return arguments;
}

std::optional<cellsweep::GiantSlot> slot_of(std::string_view word) {
  using cellsweep::GiantSlot;
  if (word == "first") return GiantSlot::first;
  if (word == "middle") return GiantSlot::middle;
  if (word == "last") return GiantSlot::last;
  return std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "--notes") {
    std::fputs(cellsweep::bench::peer_notes().c_str(), stdout);
    return 0;
  }
  cellsweep::GiantSlot giant = cellsweep::GiantSlot::none;
  std::string out = "out/peers/peers.json";
  if (argc > 1 && std::string_view(argv[1]) == "--giant") {
    const auto slot = argc > 2 ? slot_of(argv[2]) : std::nullopt;
    if (!slot) {
      std::fputs("--giant: first, middle or last is wanted.\n", stderr);
      return 2;
    }
    giant = *slot;
    out = "out/peers/giant-" + std::string(argv[2]) + ".json";
    benchmark::AddCustomContext("giant", argv[2]);
    // The name of the program stands in front of what is left.
    argv[2] = argv[0];
    argv += 2;
    argc -= 2;
  }
  std::error_code ignored;  // Google Benchmark says when it cannot write there
  std::filesystem::create_directories("out/peers", ignored);
  std::vector<char*> arguments = with_defaults(argc, argv, out);
  int count = static_cast<int>(arguments.size());
  cellsweep::bench::add_context();
  cellsweep::bench::register_peer_suite(giant);
  cellsweep::bench::register_few_suite();
  cellsweep::bench::register_tail_suite();
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
