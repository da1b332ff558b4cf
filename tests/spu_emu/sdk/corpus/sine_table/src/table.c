#include <altivec.h>
#include <libspe2.h>
#include <math.h>
#include <simdmath.h>
#include <stdio.h>

extern spe_program_handle_t sines;
static float angles[256] __attribute__((aligned(128)));
static float results[256] __attribute__((aligned(128)));

int main(void) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  int i, j, far_spe = 0, far_ppe = 0;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  for (i = 0; i < 256; i++) angles[i] = (i - 128) * 0.0490873852f;
  spe_program_load(spe, &sines);
  if (spe_context_run(spe, &entry, 0, angles, results, NULL) != 0) return 1;
  for (i = 0; i < 256; i += 4) {
    vector float mine = sinf4(*(vector float *)(angles + i));
    for (j = 0; j < 4; j++) {
      double right = sin((double)angles[i + j]);
      far_spe += fabs(results[i + j] - 2 - right) > 4e-6;
      far_ppe += fabs(((float *)&mine)[j] - right) > 1e-6;
    }
  }
  printf("far from right: %d on the SPE, %d on the PPE\n", far_spe, far_ppe);
  for (i = 96; i <= 192; i += 32) printf("sin(%.3f) + 2 = %.3f\n", angles[i], results[i]);
  return 0;
}
