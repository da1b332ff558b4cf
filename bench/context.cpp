#include "bench/context.h"

#include <benchmark/benchmark.h>

#include "report/build_context.h"

namespace cellsweep::bench {

void add_context() {
  for (const auto& [name, value] : report::build_context()) benchmark::AddCustomContext(name, value);
}

}  // namespace cellsweep::bench
