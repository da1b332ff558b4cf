/// @file
/// The program of the suite of queries: Google Benchmark's options and, by default, three repetitions, median
/// and spread, also in out/queries/queries.json unless rows are chosen. `--quick`, as the first argument,
/// asks a few questions to worlds of 1,000 bodies, once.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "bench/context.h"
#include "bench/queries/frame_suite.h"
#include "bench/queries/query_suite.h"

namespace {

using cellsweep::bench::FrameSuite;
using cellsweep::bench::QuerySuite;

constexpr std::array<std::size_t, 1> kQuickBodies = {1'000};
constexpr QuerySuite kQuick{kQuickBodies, 256};
constexpr FrameSuite kQuickFrames{kQuickBodies, 256, 30};

bool runs_all(int argc, char** argv) {
  return std::none_of(argv + 1, argv + argc, [](std::string_view argument) {
    return argument.starts_with("--benchmark_filter") || argument.starts_with("--benchmark_list_tests");
  });
}

// Options given later win, so defaults go in front of the caller's.
std::vector<char*> with_defaults(int argc, char** argv, bool quick) {
  static std::vector<std::string> defaults = {"--benchmark_report_aggregates_only=true"};
  if (!quick) defaults.emplace_back("--benchmark_repetitions=3");
  if (!quick && runs_all(argc, argv)) defaults.emplace_back("--benchmark_out=out/queries/queries.json");
  std::vector<char*> arguments = {argv[0]};
  for (std::string& option : defaults) arguments.push_back(option.data());
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  return arguments;
}

}  // namespace

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::string_view(argv[1]) == "--quick";
  if (quick) {
    argv[1] = argv[0];
    ++argv;
    --argc;
  }
  std::error_code ignored;  // Google Benchmark says when it cannot write there
  std::filesystem::create_directories("out/queries", ignored);
  std::vector<char*> arguments = with_defaults(argc, argv, quick);
  int count = static_cast<int>(arguments.size());
  cellsweep::bench::add_context();
  cellsweep::bench::register_query_suite(quick ? kQuick : QuerySuite{});
  cellsweep::bench::register_frame_suite(quick ? kQuickFrames : FrameSuite{});
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
