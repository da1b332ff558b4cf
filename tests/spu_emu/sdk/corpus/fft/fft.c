#include <libspe2.h>
#include <math.h>
#include <stdio.h>

#define N 128

extern spe_program_handle_t fft_spu;
static float x[N][2] __attribute__((aligned(128)));

int main(void) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  double energy = 0;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  for (int i = 0; i < N; i++) x[i][0] = 3 * cos(2 * M_PI * 5 * i / N) + sin(2 * M_PI * 20 * i / N) + 0.5;
  if (spe_program_load(spe, &fft_spu) || spe_context_run(spe, &entry, 0, x, NULL, NULL)) return 1;
  for (int k = 0; k <= N / 2; k++) {
    double size = hypot(x[k][0], x[k][1]);
    if (size > 0.01) printf("%3d: %.2f\n", k, size);
    energy += size * size;
  }
  printf("energy %.0f\n", energy);
  return 0;
}
