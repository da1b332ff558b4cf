// Throughput of typical intrinsics beside plain SSE code of the same meaning, over arrays that fit the L1
// cache.
//
// Each pair "intrinsics/<name>/spu" and "intrinsics/<name>/sse" processes the same 1,024 vectors; items are
// vectors. Both sides run under the SPU's MXCSR. Where SSE has no single counterpart the "sse" side is the
// code one would write without the SPU's special cases (no special selectors, counts in range, no NaN).
#include <benchmark/benchmark.h>

#include <array>
#include <cstdint>
#include <string>

#include <spu_intrinsics.h>

namespace {

constexpr std::size_t vectors = 1024;

template <typename V>
using Array = std::array<V, vectors>;

// Values that are ordinary floats and varied integers at once.
template <typename V>
Array<V> make_inputs(std::uint32_t seed) {
  Array<V> a;
  for (V& v : a) {
    vec_uint4 words;
    for (int k = 0; k < 4; ++k) {
      seed = seed * 1664525U + 1013904223U;
      words[k] = (seed & 0x03ffffffU) | 0x3e000000U;
    }
    v = (V)words;
  }
  return a;
}

template <typename V, typename F>
void run_binary(benchmark::State& state, F f) {
  const spu_emu::SpuFloatMode mode;
  const Array<V> a = make_inputs<V>(1);
  const Array<V> b = make_inputs<V>(2);
  Array<decltype(f(a[0], b[0]))> out;
  for (auto _ : state) {
    for (std::size_t i = 0; i < vectors; ++i) out[i] = f(a[i], b[i]);
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(vectors));
}

template <typename V, typename Spu, typename Sse>
void add_pair(const std::string& name, Spu spu, Sse sse) {
  benchmark::RegisterBenchmark(("intrinsics/" + name + "/spu").c_str(),
                               [spu](benchmark::State& s) { run_binary<V>(s, spu); });
  benchmark::RegisterBenchmark(("intrinsics/" + name + "/sse").c_str(),
                               [sse](benchmark::State& s) { run_binary<V>(s, sse); });
}

using F = vec_float4;
using U = vec_uint4;
using H = vec_ushort8;

__m128 ps(F v) {
  return (__m128)v;
}
__m128i si(U v) {
  return (__m128i)v;
}

void add_float_pairs() {
  add_pair<F>(
      "add_float", [](F a, F b) { return spu_add(a, b); },
      [](F a, F b) { return (F)_mm_add_ps(ps(a), ps(b)); });
  add_pair<F>(
      "mul_float", [](F a, F b) { return spu_mul(a, b); },
      [](F a, F b) { return (F)_mm_mul_ps(ps(a), ps(b)); });
  add_pair<F>(
      "madd_float", [](F a, F b) { return spu_madd(a, b, a); },
      [](F a, F b) { return (F)_mm_add_ps(_mm_mul_ps(ps(a), ps(b)), ps(a)); });
  add_pair<F>(
      "cmpgt_float", [](F a, F b) { return spu_cmpgt(a, b); },
      [](F a, F b) { return (U)_mm_cmpgt_ps(ps(a), ps(b)); });
  add_pair<F>(
      "min_by_select", [](F a, F b) { return spu_sel(a, b, spu_cmpgt(a, b)); },
      [](F a, F b) { return (F)_mm_min_ps(ps(a), ps(b)); });
  add_pair<F>(
      "reciprocal_estimate", [](F a, F) { return spu_re(a); }, [](F a, F) { return (F)_mm_rcp_ps(ps(a)); });
  add_pair<F>(
      "to_int", [](F a, F) { return spu_convts(a, 0); }, [](F a, F) { return (U)_mm_cvttps_epi32(ps(a)); });
}

void add_integer_pairs() {
  add_pair<U>(
      "add_word", [](U a, U b) { return spu_add(a, b); },
      [](U a, U b) { return (U)_mm_add_epi32(si(a), si(b)); });
  add_pair<U>(
      "cmpgt_unsigned", [](U a, U b) { return spu_cmpgt(a, b); },
      [](U a, U b) { return (U)_mm_cmpgt_epi32(si(a), si(b)); });
  add_pair<U>(
      "select", [](U a, U b) { return spu_sel(a, b, spu_cmpgt(a, b)); },
      [](U a, U b) { return (U)_mm_blendv_epi8(si(a), si(b), _mm_cmpgt_epi32(si(a), si(b))); });
  add_pair<H>(
      "mule_half", [](H a, H b) { return spu_mule(a, b); },
      [](H a, H b) { return (U)_mm_madd_epi16((__m128i)a, (__m128i)b); });
  add_pair<U>(
      "count_leading_zeros", [](U a, U) { return spu_cntlz(a); },
      [](U a, U) {
        return U{static_cast<unsigned>(__builtin_clz(a[0])), static_cast<unsigned>(__builtin_clz(a[1])),
                 static_cast<unsigned>(__builtin_clz(a[2])), static_cast<unsigned>(__builtin_clz(a[3]))};
      });
  add_pair<U>(
      "gather", [](U a, U) { return spu_gather(a); },
      [](U a, U) {
        return U{static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(si(a)))), 0, 0, 0};
      });
}

void add_quadword_pairs() {
  add_pair<U>(
      "shuffle_literal",
      [](U a, U b) {
        return spu_shuffle(a, b, vec_uchar16{4, 5, 6, 7, 20, 21, 22, 23, 0, 1, 2, 3, 28, 29, 30, 31});
      },
      [](U a, U b) {
        const __m128 pair =
            _mm_shuffle_ps(_mm_castsi128_ps(si(a)), _mm_castsi128_ps(si(b)), _MM_SHUFFLE(3, 1, 0, 1));
        return (U)_mm_castps_si128(_mm_shuffle_ps(pair, pair, _MM_SHUFFLE(3, 1, 2, 0)));
      });
  add_pair<U>(
      "shuffle_variable", [](U a, U b) { return spu_shuffle(a, b, (vec_uchar16)b); },
      [](U a, U b) { return (U)_mm_shuffle_epi8(si(a), si(b)); });
  add_pair<U>(
      "rotate_4_bytes", [](U a, U) { return spu_rlqwbyte(a, 4); },
      [](U a, U) { return (U)_mm_shuffle_epi32(si(a), _MM_SHUFFLE(0, 3, 2, 1)); });
  add_pair<U>(
      "rotate_word", [](U a, U) { return spu_rl(a, 5); },
      [](U a, U) { return (U)_mm_or_si128(_mm_slli_epi32(si(a), 5), _mm_srli_epi32(si(a), 27)); });
}

[[maybe_unused]] const bool registered = [] {
  add_float_pairs();
  add_integer_pairs();
  add_quadword_pairs();
  return true;
}();

}  // namespace
