#include <libspe2.h>
#include <stdio.h>
#include "rows.h"
extern spe_program_handle_t rows_handle;
static struct matrix m __attribute__((aligned(128)));

static int run(void *argp, void *envp) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe == NULL || spe_program_load(spe, &rows_handle) != 0) return -1;
  if (spe_context_run(spe, &entry, 0, argp, envp, &stop) != 0) return -2;
  spe_context_destroy(spe);
  return stop.result.spe_exit_code;
}

int main(void) {
  double sum = 0;
  int wrong = 0;
  for (int i = 0; i < N; i++) {
    m.x[i][0] = i % 9 - 4;
    for (int k = 0; k < PER_ROW; k++) {
      m.columns[i][k] = (i * 3 + k * k * 7) % N;
      m.values[i][k] = (i + k) % 5 - 1.5f;
    }
  }
  if (run(&m, NULL)) return 1;
  for (int i = 0; i < N; i++) {
    float y = 0;
    for (int k = 0; k < PER_ROW; k++) y += m.values[i][k] * m.x[m.columns[i][k]][0];
    wrong += y != m.y[i];
    sum += m.y[i];
  }
  printf("%d wrong, y[0] %g, y[63] %g, sum %g\n", wrong, m.y[0], m.y[63], sum);
  return 0;
}
