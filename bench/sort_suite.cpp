#include "bench/sort_suite.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engines/cell/ppu/dma_memory.h"
#include "engines/cell/spu/paper/intervector_sort.h"
#include "engines/cell/spu/paper/intravector_sort.h"

namespace cellsweep::bench {
namespace {

using cell::paper::EarlyOut;

struct Endpoints {
  cell::DmaVector<float> values;
  cell::DmaVector<std::uint32_t> ids;
};

void scalar_insertion(Endpoints& ends) {
  for (std::size_t i = 1; i < ends.values.size(); ++i) {
    const float value = ends.values[i];
    const std::uint32_t id = ends.ids[i];
    std::size_t j = i;
    for (; j > 0 && ends.values[j - 1] > value; --j) {
      ends.values[j] = ends.values[j - 1];
      ends.ids[j] = ends.ids[j - 1];
    }
    ends.values[j] = value;
    ends.ids[j] = id;
  }
}

void simd_insertion(Endpoints& ends, EarlyOut early_out) {
  const auto vectors = static_cast<std::uint32_t>(ends.values.size() / 4);
  cell::paper::intervector_sort(ends.values.data(), ends.ids.data(), vectors, early_out);
  cell::paper::intravector_sort(ends.values.data(), ends.ids.data(), vectors);
}

void std_sort(Endpoints& ends) {
  std::vector<std::pair<float, std::uint32_t>> pairs(ends.values.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) pairs[i] = {ends.values[i], ends.ids[i]};
  std::sort(pairs.begin(), pairs.end());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    ends.values[i] = pairs[i].first;
    ends.ids[i] = pairs[i].second;
  }
}

struct Kernel {
  const char* name;
  void (*sort)(Endpoints&);
};

constexpr std::array kKernels = {
    Kernel{"scalar_insertion", scalar_insertion},
    Kernel{"simd_insertion", [](Endpoints& ends) { simd_insertion(ends, EarlyOut::yes); }},
    Kernel{"simd_insertion_no_early_out", [](Endpoints& ends) { simd_insertion(ends, EarlyOut::no); }},
    Kernel{"std_sort", std_sort}};

struct Input {
  const char* name;
  float disorder;       ///< how far a value may be from its place, in places
  std::uint32_t every;  ///< one value in so many is out of place
};

constexpr std::array kInputs = {Input{"random", 1e9F, 1}, Input{"sorted", 0, 1}, Input{"nearly", 5, 10}};

Endpoints make_endpoints(std::size_t count, const Input& input) {
  Endpoints ends{cell::DmaVector<float>(count), cell::DmaVector<std::uint32_t>(count)};
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < count; ++i) {
    state = state * 1664525U + 1013904223U;
    const float away =
        i % input.every == 0 ? static_cast<float>(state >> 8) / static_cast<float>(1U << 24) : 0;
    ends.values[i] = static_cast<float>(i) + away * input.disorder;
    ends.ids[i] = static_cast<std::uint32_t>(i / 2 + 1);
  }
  return ends;
}

void run_row(benchmark::State& state, const Kernel& kernel, const Input& input, std::size_t count) {
  const Endpoints given = make_endpoints(count, input);
  Endpoints ends = given;
  for (auto _ : state) {
    state.PauseTiming();
    std::copy(given.values.begin(), given.values.end(), ends.values.begin());
    std::copy(given.ids.begin(), given.ids.end(), ends.ids.begin());
    state.ResumeTiming();
    kernel.sort(ends);
    benchmark::ClobberMemory();
  }
  if (!std::is_sorted(ends.values.begin(), ends.values.end()))
    state.SkipWithError("the values are not sorted");
  state.counters["values/s"] =
      benchmark::Counter(static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate);
}

}  // namespace

void register_sort_suite() {
  for (const Kernel& kernel : kKernels) {
    for (const std::size_t count : {128U, 512U, 2048U, 8192U}) {
      for (const Input& input : kInputs) {
        const std::string name =
            "sort/" + std::string(kernel.name) + "/" + std::to_string(count) + "/" + std::string(input.name);
        benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
          run_row(state, kernel, input, count);
        })->Unit(benchmark::kMicrosecond);
      }
    }
  }
}

}  // namespace cellsweep::bench
