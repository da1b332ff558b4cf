// HUGE_VALF is the largest number, and what too large a result becomes.
#include <spu_intrinsics.h>

#include <cmath>

int main() {
  volatile float large = 3e38F;
  const float product = large * large;
  if (product != HUGE_VALF || large > HUGE_VALF || -product != -HUGE_VALF) return 1;
  const vec_float4 overflow =
      spu_mul(spu_splats(static_cast<float>(large)), spu_splats(static_cast<float>(large)));
  if (spu_extract(spu_cmpgt(overflow, spu_splats(HUGE_VALF)), 0) != 0) return 2;
  volatile float huge = HUGE_VALF;
  return huge - 1e37F < huge ? 42 : 3;
}
