/* Rows of blocks of C = A * B: a block is got row by row, as each of its rows lies alone in memory. */
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

#include "matrix.h"

static job_t job __attribute__((aligned(128)));
static float a[BLOCK][BLOCK] __attribute__((aligned(128)));
static float b[BLOCK][BLOCK] __attribute__((aligned(128)));
static float c[BLOCK][BLOCK] __attribute__((aligned(128)));

static void get_block(float to[BLOCK][BLOCK], unsigned long long from, int row, int column, int tag) {
  int i;
  for (i = 0; i < BLOCK; i++) {
    mfc_get(to[i], from + ((row * BLOCK + i) * N + column * BLOCK) * sizeof(float), sizeof to[i], tag, 0, 0);
  }
}

static void multiply_add(void) {
  int i, j, k;
  for (i = 0; i < BLOCK; i++) {
    vec_float4 *out = (vec_float4 *)c[i];
    for (k = 0; k < BLOCK; k++) {
      const vec_float4 factor = spu_splats(a[i][k]);
      const vec_float4 *in = (vec_float4 *)b[k];
      for (j = 0; j < BLOCK / 4; j++) out[j] = spu_madd(factor, in[j], out[j]);
    }
  }
}

int main(unsigned long long spe, unsigned long long argp, unsigned long long envp) {
  int column, k, i;
  (void)spe;
  (void)envp;
  mfc_get(&job, argp, sizeof job, 0, 0, 0);
  mfc_write_tag_mask(3);
  mfc_read_tag_status_all();
  for (column = 0; column < N / BLOCK; column++) {
    for (i = 0; i < BLOCK * BLOCK; i++) c[0][i] = 0;
    for (k = 0; k < N / BLOCK; k++) {
      get_block(a, job.a, job.row, k, 0);
      get_block(b, job.b, k, column, 1);
      mfc_read_tag_status_all();
      multiply_add();
    }
    for (i = 0; i < BLOCK; i++) {
      mfc_put(c[i], job.c + ((job.row * BLOCK + i) * N + column * BLOCK) * sizeof(float), sizeof c[i], 0, 0, 0);
    }
    mfc_read_tag_status_all();
  }
  return 0;
}
