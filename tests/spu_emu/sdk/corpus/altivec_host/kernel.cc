#include <spu_intrinsics.h>
#include <spu_mfcio.h>
#include <vmx2spu.h>

static vec_float4 data[64] __attribute__((aligned(128)));

int main(unsigned long long, unsigned long long ea, unsigned long long) {
  const vec_float4 half = {0.5f, 0.5f, 0.5f, 0.5f};
  int i;
  spu_mfcdma64(data, ea >> 32, ea & 0xffffffff, sizeof data, 0, MFC_GET_CMD);
  spu_writech(MFC_WrTagMask, 1);
  spu_mfcstat(2);
  for (i = 0; i < 64; i++) data[i] = vec_madd(data[i], data[i], half);
  spu_mfcdma64(data, ea >> 32, ea & 0xffffffff, sizeof data, 0, MFC_PUT_CMD);
  spu_mfcstat(2);
  return 0;
}
