// Simulated instructions a second of the instruction-level engine: items are instructions.
//
// "loop" is five integer instructions around one register, "insertion_sort" sorts 256 words in the local
// store the way a compiler writes it (loads, rotates and shuffles around every word), "float" a chain of
// single-precision multiply-adds over an array.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <random>

#include "isa/core/machine.h"
#include "mfc/decrementer.h"
#include "mfc/spu_channels.h"
#include "spu_emu/isa/encoding/assembler.h"

namespace {

using spu_emu::isa::encode;
using spu_emu::isa::Machine;

struct alignas(128) LocalBytes {
  std::array<std::byte, 0x40000> bytes{};
};

constexpr std::uint32_t kData = 0x8000;
constexpr int kWords = 256;
constexpr std::uint32_t kStop = 0;

/// A machine with a program at address 0.
class Spu {
 public:
  explicit Spu(std::initializer_list<std::uint32_t> program) {
    std::uint32_t address = 0;
    for (const std::uint32_t word : program) put(4 * address++, word);
  }
  void put(std::uint32_t address, std::uint32_t word) {
    const std::uint32_t bytes = __builtin_bswap32(word);
    std::memcpy(local->bytes.data() + address, &bytes, sizeof bytes);
  }
  void run(benchmark::State& state) {
    machine.set_pc(0);
    if (machine.run(1'000'000'000).kind != spu_emu::isa::MachineStop::Kind::stop)
      state.SkipWithError("the program did not stop");
  }
  void count(benchmark::State& state) {
    state.SetItemsProcessed(static_cast<std::int64_t>(machine.instructions()));
  }

  std::unique_ptr<LocalBytes> local = std::make_unique<LocalBytes>();
  spu_emu::FlatLocalStore store{local->bytes.data(), 0x40000, spu_emu::WordOrder::swapped};
  spu_emu::SteadyTimebase timebase{79.8e6};
  spu_emu::SpuChannels channels{store, timebase, {}};
  Machine machine{local->bytes.data(), channels};
};

void loop(benchmark::State& state) {
  Spu spu({encode("ilhu", {3, 2}), encode("ai", {3, 3, -1}), encode("a", {4, 4, 3}), encode("xor", {5, 5, 4}),
           encode("roti", {5, 5, 3}), encode("brnz", {3, -16}), kStop});
  for (auto _ : state) spu.run(state);
  spu.count(state);
}

/// $3 the words' address, $4 their bytes, $5 the place of the key $6, $8 the place that is free for it.
void insertion_sort(benchmark::State& state) {
  Spu spu({encode("ila", {3, kData}),         encode("ila", {4, 4 * kWords}), encode("ila", {5, 4}),
           encode("lqx", {6, 3, 5}),          encode("a", {7, 3, 5}),         encode("rotqby", {6, 6, 7}),
           encode("ori", {8, 5, 0}),          encode("ai", {9, 8, -4}),       encode("lqx", {10, 3, 9}),
           encode("a", {11, 3, 9}),           encode("rotqby", {10, 10, 11}), encode("cgt", {12, 10, 6}),
           encode("brz", {12, 28}),           encode("lqx", {13, 3, 8}),      encode("cwx", {14, 3, 8}),
           encode("shufb", {13, 10, 13, 14}), encode("stqx", {13, 3, 8}),     encode("ai", {8, 8, -4}),
           encode("brnz", {8, -44}),          encode("lqx", {13, 3, 8}),      encode("cwx", {14, 3, 8}),
           encode("shufb", {13, 6, 13, 14}),  encode("stqx", {13, 3, 8}),     encode("ai", {5, 5, 4}),
           encode("cgt", {15, 4, 5}),         encode("brnz", {15, -88}),      kStop});
  std::mt19937 random(1);
  std::array<std::uint32_t, kWords> words{};
  for (std::uint32_t& word : words) word = static_cast<std::uint32_t>(random());
  for (auto _ : state) {
    std::memcpy(spu.local->bytes.data() + kData, words.data(), sizeof words);
    spu.run(state);
  }
  spu.count(state);
  std::array<std::int32_t, kWords> sorted{};
  std::memcpy(sorted.data(), spu.local->bytes.data() + kData, sizeof sorted);
  for (std::int32_t& word : sorted)
    word = static_cast<std::int32_t>(__builtin_bswap32(static_cast<std::uint32_t>(word)));
  if (!std::ranges::is_sorted(sorted)) state.SkipWithError("not sorted");
}

/// $6 += word * $5 for the quadwords at $3, $4 of them.
void float_madd(benchmark::State& state) {
  Spu spu({encode("ila", {3, kData}), encode("ila", {4, 4096}), encode("ilhu", {5, 0x3f80}),
           encode("lqd", {7, 0, 3}), encode("lqd", {8, 16, 3}), encode("fma", {6, 7, 5, 6}),
           encode("fma", {6, 8, 5, 6}), encode("fa", {9, 7, 8}), encode("fm", {10, 7, 8}),
           encode("fcgt", {11, 7, 8}), encode("ai", {3, 3, 32}), encode("ai", {4, 4, -1}),
           encode("brnz", {4, -36}), kStop});
  for (std::uint32_t k = 0; k < 4 * 8192; ++k) spu.put(kData + 4 * k, 0x3f800000 + 977 * k);
  for (auto _ : state) spu.run(state);
  spu.count(state);
}

}  // namespace

BENCHMARK(loop)->Name("isa/loop");
BENCHMARK(insertion_sort)->Name("isa/insertion_sort");
BENCHMARK(float_madd)->Name("isa/float");
