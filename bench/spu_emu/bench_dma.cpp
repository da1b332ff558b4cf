// DMA bandwidth by transfer size and mode, against memcpy of the same bytes in the same pieces; 64 MB each
// time.
#include <benchmark/benchmark.h>
#include <libspe2.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <vector>

#include "bench_dma.h"
#include "spu_emu/emulation.h"

extern "C" spe_program_handle_t bench_dma_program;

namespace {

constexpr std::size_t kBytes = std::size_t{64} << 20U;

struct alignas(4096) Page {
  char bytes[4096];
};

std::vector<Page>& source() {
  static std::vector<Page> pages(kBytes / sizeof(Page), Page{{1}});
  return pages;
}

void copy_pieces(benchmark::State& state) {
  const auto piece = static_cast<std::size_t>(state.range(0));
  alignas(4096) static char buffer[16384];
  const char* from = source().data()->bytes;
  for (auto _ : state) {
    for (std::size_t done = 0; done < kBytes; done += piece) {
      std::memcpy(buffer, from + done, piece);
      benchmark::DoNotOptimize(buffer);
      benchmark::ClobberMemory();
    }
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(kBytes));
}

void dma(benchmark::State& state) {
  spu_emu::EmulationSettings settings;
  settings.dma_mode = static_cast<spu_emu::DmaMode>(state.range(1));
  const spu_emu::SettingsScope scope(settings);
  DmaJob job{reinterpret_cast<unsigned long long>(source().data()), kBytes,
             static_cast<unsigned long long>(state.range(0))};
  spe_context_ptr_t spe = spe_context_create(0, nullptr);
  spe_program_load(spe, &bench_dma_program);
  unsigned int entry = SPE_DEFAULT_ENTRY;
  for (auto _ : state) {
    if (spe_context_run(spe, &entry, 0, &job, nullptr, nullptr) != 1)
      state.SkipWithError("the SPU program failed");
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(kBytes));
  spe_context_destroy(spe);
}

template <class Work>
double seconds_of(Work&& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

/// memcpy and eager DMA of the same bytes in turn, so that both see the same machine: what the emulation
/// costs.
void eager_against_memcpy(benchmark::State& state) {
  DmaJob job{reinterpret_cast<unsigned long long>(source().data()), kBytes, 16384};
  spe_context_ptr_t spe = spe_context_create(0, nullptr);
  spe_program_load(spe, &bench_dma_program);
  unsigned int entry = SPE_DEFAULT_ENTRY;
  alignas(4096) static char buffer[16384];
  std::vector<double> ratios;
  for (auto _ : state) {
    const double plain = seconds_of([] {
      for (std::size_t done = 0; done < kBytes; done += sizeof buffer) {
        std::memcpy(buffer, source().data()->bytes + done, sizeof buffer);
        benchmark::DoNotOptimize(buffer);
        benchmark::ClobberMemory();
      }
    });
    const double moved = seconds_of([&] { spe_context_run(spe, &entry, 0, &job, nullptr, nullptr); });
    ratios.push_back(moved / plain);
  }
  state.counters["median_ratio"] = median(ratios);
  spe_context_destroy(spe);
}

}  // namespace

BENCHMARK(eager_against_memcpy)->Iterations(101);
BENCHMARK(copy_pieces)->Name("memcpy")->ArgName("size")->Arg(128)->Arg(1024)->Arg(4096)->Arg(16384);
BENCHMARK(dma)->ArgNames({"size", "mode"})->ArgsProduct({{128, 1024, 4096, 16384}, {0, 1, 2}});
