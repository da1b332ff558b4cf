#include <fenv.h>
#include <libspe2.h>
#include <math.h>
#include <stdio.h>

extern spe_program_handle_t steps;
static int walks[8][8] __attribute__((aligned(128)));
static int ends[8][2] __attribute__((aligned(128)));

static void bearings(const char *how) {
  int i;
  for (i = 0; i < 8; i++) {
    double a = atan2(ends[i][0], ends[i][1]);
    printf("%s %d %d: %.17g %.17g %.17g %.17g %.17g\n", how, ends[i][0], ends[i][1], a, sin(a), cos(a), tan(a),
           atan(a * 1e3));
  }
}

int main(void) {
  unsigned int entry = SPE_DEFAULT_ENTRY, seed = 2006;
  int i;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  for (i = 0; i < 64; i++) walks[i / 8][i % 8] = (int)((seed = seed * 1103515245u + 12345u) >> 16) % 200 - 100;
  if (spe == NULL || spe_program_load(spe, &steps) != 0) return 1;
  if (spe_context_run(spe, &entry, 0, walks, ends, NULL) != 0) return 1;
  bearings("nearest");
  fesetround(FE_UPWARD);
  bearings("upward");
  printf("still upward: %d\n", fegetround() == FE_UPWARD);
  return spe_context_destroy(spe);
}
