#include "bench/context.h"

#include <benchmark/benchmark.h>

#include <fstream>
#include <string>

#include "commit.h"

namespace cellsweep::bench {
namespace {

std::string cpu_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

}  // namespace

void add_context() {
  benchmark::AddCustomContext("cpu", cpu_name());
  benchmark::AddCustomContext("compiler", CELLSWEEP_COMPILER);
  benchmark::AddCustomContext("flags", CELLSWEEP_FLAGS);
  benchmark::AddCustomContext("commit", CELLSWEEP_COMMIT);
}

}  // namespace cellsweep::bench
