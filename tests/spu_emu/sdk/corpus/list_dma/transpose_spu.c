// Gathers a column of tiles by a list with a stall in its middle, transposes the tiles, and scatters a row by a list.
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

#include "transpose.h"

static struct matrices matrices;
static mfc_list_element_t list[N] __attribute__((aligned(8)));
static vec_float4 column[N] __attribute__((aligned(128)));
static vec_float4 rows[TILE][N / TILE] __attribute__((aligned(128)));

static void wait(unsigned int tag) {
  mfc_write_tag_mask(1 << tag);
  mfc_read_tag_status_all();
}

static void fill(unsigned long long first, unsigned int stride, unsigned int count, unsigned int bytes) {
  for (unsigned int i = 0; i < count; i++) {
    list[i].notify = i == count / 2;
    list[i].reserved = 0;
    list[i].size = bytes;
    list[i].eal = mfc_ea2l(first) + i * stride;
  }
}


int main(unsigned long long spe, unsigned long long argp, unsigned long long envp) {
  int stalls = 0;
  (void)spe;
  (void)envp;
  mfc_get(&matrices, argp, sizeof matrices, 0, 0, 0);
  wait(0);
  for (unsigned int tile = 0; tile < N / TILE; tile++) {
    fill(matrices.from + tile * 16, N * 4, N, 16);
    mfc_getl(column, matrices.from, list, sizeof list, 3, 0, 0);
    if (mfc_read_list_stall_status() == 1u << 3) {
      stalls++;
      mfc_write_list_stall_ack(3);
    }
    wait(3);
    for (unsigned int k = 0; k < N / TILE; k++) {
      for (unsigned int r = 0; r < TILE; r++) {
        vec_float4 row = spu_splats(0.0f);
        for (unsigned int c = 0; c < TILE; c++) row = spu_insert(spu_extract(column[k * TILE + c], r), row, c);
        rows[r][k] = row;
      }
    }
    fill(matrices.to + tile * TILE * N * 4, N * 4, TILE, N * 4);
    list[TILE / 2].notify = 0;
    mfc_putl(rows, matrices.to, list, TILE * sizeof list[0], 4, 0, 0);
    wait(4);
  }
  return stalls;
}
