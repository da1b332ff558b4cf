#include <libspe2.h>
#include <pthread.h>
#include <stdio.h>

#include "matrix.h"

extern spe_program_handle_t block;

static float a[N][N] __attribute__((aligned(128)));
static float b[N][N] __attribute__((aligned(128)));
static float c[N][N] __attribute__((aligned(128)));
static job_t jobs[N / BLOCK];

static void *run(void *job) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe_program_load(spe, &block) || spe_context_run(spe, &entry, 0, job, NULL, NULL) < 0) perror("spe");
  spe_context_destroy(spe);
  return NULL;
}

int main(void) {
  pthread_t threads[N / BLOCK];
  int i, j, k, wrong = 0;
  float trace = 0;

  for (i = 0; i < N; i++) {
    for (j = 0; j < N; j++) {
      a[i][j] = (i + 2 * j) % 7 - 3;
      b[i][j] = (3 * i + j) % 5 - 2;
    }
  }
  for (i = 0; i < N / BLOCK; i++) {
    job_t job = {(unsigned long long)a, (unsigned long long)b, (unsigned long long)c, i, 0};
    jobs[i] = job;
    pthread_create(&threads[i], NULL, run, &jobs[i]);
  }
  for (i = 0; i < N / BLOCK; i++) pthread_join(threads[i], NULL);
  for (i = 0; i < N; i++) {
    trace += c[i][i];
    for (j = 0; j < N; j++) {
      float sum = 0;
      for (k = 0; k < N; k++) sum += a[i][k] * b[k][j];
      wrong += sum != c[i][j];
    }
  }
  printf("%d wrong, trace %g, c[5][9] %g\n", wrong, trace, c[5][9]);
  return 0;
}
