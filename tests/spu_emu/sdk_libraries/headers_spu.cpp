// Every header of the SDK's libraries in one program; the exit code is the number of the first check that fails.
#include <cbe_mfc.h>
#include <libmisc.h>
#include <libsync.h>
#include <massv.h>
#include <profile.h>
#include <simdmath.h>
#include <spu_timer.h>
#include <vec_literal.h>

#include <cstdint>

namespace {

int failure = 0;
int number = 0;

void check(bool holds) {
  ++number;
  if (!holds && failure == 0) failure = number;
}

void check_memory() {
  auto* block = static_cast<unsigned char*>(malloc_align(100, 7));
  check(block != nullptr && (reinterpret_cast<std::uintptr_t>(block) & 127) == 0);
  block[99] = 5;
  block = static_cast<unsigned char*>(realloc_align(block, 1000, 8));
  check(block != nullptr && (reinterpret_cast<std::uintptr_t>(block) & 255) == 0 && block[99] == 5);
  free_align(block);
  auto* zeros = static_cast<unsigned char*>(calloc_align(7, 3, 4));
  check(zeros != nullptr && zeros[20] == 0);
  free_align(zeros);
  free_align(nullptr);
  check(malloc_align(~static_cast<std::size_t>(0) - 10, 7) == nullptr);
}

void check_vectors() {
  const vec_float4 values = VEC_LITERAL(vec_float4, -2.0f, 0.5f, 3.0f, 7.0f);
  check(spu_extract(clamp_0_to_1_v(values), 0) == 0.0f && spu_extract(clamp_0_to_1_v(values), 3) == 1.0f);
  check(spu_extract(clamp_minus1_to_1_v(values), 0) == -1.0f && spu_extract(clamp_minus1_to_1_v(values), 1) == 0.5f);
  check(max_vec_float4(values) == 7.0f && max_vec_float3(values) == 3.0f && min_vec_float4(values) == -2.0f);
  check(spu_extract(max_float_v(values, VEC_SPLAT_F32(1.0f)), 1) == 1.0f);
  check(spu_extract(min_int_v(VEC_SPLAT_S32(-4), VEC_SPLAT_S32(4)), 2) == -4);
  check(clamp(5.0f, 0.0f, 2.0f) == 2.0f && clamp_minus1_to_1(-3.0f) == -1.0f);
  unsigned char bytes[20] = {};
  store_vec_unaligned(bytes + 3, VEC_SPLAT_U8(9));
  check(bytes[2] == 0 && bytes[3] == 9 && bytes[18] == 9 && bytes[19] == 0);
  check(spu_extract(load_vec_unaligned(bytes + 3), 15) == 9);
}

void check_random() {
  srand_v(VEC_LITERAL(vec_uint4, 1u, 2u, 3u, 4u));
  check(spu_extract(rand_v(), 0) == 270369);  // xorshift's first after 1
  for (int i = 0; i < 100; ++i) {
    const vec_float4 positive = rand_0_to_1_v();
    const vec_float4 both = rand_minus1_to_1_v();
    check(spu_extract(positive, 1) >= 0.0f && spu_extract(positive, 1) < 1.0f);
    check(spu_extract(both, 1) >= -1.0f && spu_extract(both, 1) < 1.0f);
    const float scalar = rand_0_to_1();
    check(scalar >= 0.0f && scalar < 1.0f);
  }
}

void check_clock() {
  check(spu_clock_stop() == SPU_CLOCK_ERR_NOT_RUNNING);
  spu_clock_start();
  const std::uint64_t first = spu_clock_read();
  check(spu_clock_read() >= first);
  check(spu_clock_stop() == 0);
}

void check_mathematics() {
  prof_start();
  check(spu_extract(sqrtf4(VEC_SPLAT_F32(9.0f)), 0) == 3.0f);
  check(spu_extract(floorf4(VEC_SPLAT_F32(-1.5f)), 3) == -2.0f);
  const divi4_t quotient = divi4(VEC_SPLAT_S32(17), VEC_SPLAT_S32(-5));
  check(spu_extract(quotient.quot, 1) == -3 && spu_extract(quotient.rem, 1) == 2);
  float in[5] = {1.0f, 4.0f, 9.0f, 16.0f, 25.0f};
  float out[6] = {0, 0, 0, 0, 0, -1};
  int count = 5;
  vssqrt(out, in, &count);
  check(out[0] == 1.0f && out[4] == 5.0f && out[5] == -1.0f);
  double doubles[3] = {2.0, 3.0, -1.0};
  double powers[3] = {};
  const double exponents[3] = {10.0, 4.0, 3.0};
  count = 3;
  vpow(powers, doubles, exponents, &count);
  check(powers[0] == 1024.0 && powers[1] == 81.0 && powers[2] == -1.0);
  vrec(doubles, doubles, &count);
  check(doubles[0] == 0.5 && doubles[2] == -1.0);
  prof_cp7();
  prof_stop();
}

}  // namespace

int main(unsigned long long, unsigned long long, unsigned long long) {
  check(MFC_GET_CMD == 0x40 && MFC_MAX_DMA_SIZE == 16384);
  check_memory();
  check_vectors();
  check_random();
  check_clock();
  check_mathematics();
  return failure;
}
