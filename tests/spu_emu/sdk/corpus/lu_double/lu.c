#include <libspe2.h>
#include <stdio.h>
#include <math.h>
extern spe_program_handle_t factor;
#define N 16
static double a[N][N] __attribute__((aligned(128)));
static double kept[N][N];

static int run(void *argp, void *envp) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe == NULL || spe_program_load(spe, &factor) != 0) return -1;
  if (spe_context_run(spe, &entry, 0, argp, envp, &stop) != 0) return -2;
  spe_context_destroy(spe);
  return stop.result.spe_exit_code;
}

int main(void) {
  int i, j, k;
  double error = 0, determinant = 1;
  for (i = 0; i < N; i++) {
    for (j = 0; j < N; j++) kept[i][j] = a[i][j] = (i == j ? 4 : 0) + 1.0 / (1 + i + j);
  }
  if (run(a, NULL)) return 1;
  for (i = 0; i < N; i++) {
    determinant *= a[i][i];
    for (j = 0; j < N; j++) {
      double sum = 0;
      for (k = 0; k <= i && k <= j; k++) sum += (k == i ? 1 : a[i][k]) * a[k][j];
      error = fmax(error, fabs(sum - kept[i][j]));
    }
  }
  printf("%s, determinant %.8e\n", error < 1e-14 ? "the product is the matrix" : "WRONG", determinant);
  return 0;
}
