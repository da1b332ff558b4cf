// The SDK's headers, and the function of vmx2spu.h that was no C++; exits with 0 if what they do is right.
#include <free_align.h>
#include <malloc_align.h>
#include <spu_intrinsics.h>
#include <spu_mfcio.h>
#include <vec_types.h>
#include <vmx2spu.h>

int main() {
  auto* words = static_cast<vec_int4*>(_malloc_align(2 * sizeof(vec_int4), 7));
  words[0] = (vec_int4){1, 2, 3, 4};
  words[1] = vec_sum2s(words[0], ((vec_int4){0, 10, 0, 20}));
  const bool right =
      spu_extract(words[1], 1) == 13 && spu_extract(words[1], 3) == 27 && mfc_ceil128(129) == 256;
  _free_align(words);
  return right ? 0 : 1;
}
