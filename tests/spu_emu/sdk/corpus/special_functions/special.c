#include <simdmath.h>
#include <spu_intrinsics.h>
#include <spu_mfcio.h>
#include "special.h"

static results out __attribute__((aligned(128)));

int main(unsigned long long spe, unsigned long long to) {
  vec_float4 x = {0.5f, 2.25f, -1.5f, 6.0f};
  vec_double2 d = {-3.75, 9.5};
  (void)spe;
  *(vec_float4 *)out.floats[0] = erff4(x);
  *(vec_float4 *)out.floats[1] = erfcf4(x);
  *(vec_float4 *)out.floats[2] = lgammaf4(x);
  *(vec_float4 *)out.floats[3] = tgammaf4(x);
  *(vec_double2 *)out.doubles[0] = erfd2(d);
  *(vec_double2 *)out.doubles[1] = erfcd2(d);
  *(vec_double2 *)out.doubles[2] = lgammad2(d);
  *(vec_double2 *)out.doubles[3] = tgammad2(d);
  mfc_put(&out, to, sizeof out, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  return 0;
}
