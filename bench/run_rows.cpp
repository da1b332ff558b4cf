#include "bench/run_rows.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <string_view>
#include <system_error>

#include "report/build_context.h"

namespace cellsweep::bench {
namespace {

// A few rows, or a list of them, do not take the place of all of them.
bool runs_all(int argc, char** argv) {
  return std::none_of(argv + 1, argv + argc, [](std::string_view argument) {
    return argument.starts_with("--benchmark_filter") || argument.starts_with("--benchmark_list_tests");
  });
}

}  // namespace

// Of an option that is given twice the later one counts.
int run_rows(int argc, char** argv, std::vector<std::string> defaults, const std::filesystem::path& out) {
  if (!out.empty() && runs_all(argc, argv)) {
    std::error_code ignored;  // Google Benchmark says when it cannot write there
    std::filesystem::create_directories(out.parent_path(), ignored);
    defaults.push_back("--benchmark_out=" + out.string());
  }
  std::vector<char*> arguments = {argv[0]};
  for (std::string& option : defaults) arguments.push_back(option.data());
  arguments.insert(arguments.end(), argv + 1, argv + argc);
  int count = static_cast<int>(arguments.size());
  for (const auto& [name, value] : report::build_context()) benchmark::AddCustomContext(name, value);
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}

}  // namespace cellsweep::bench
