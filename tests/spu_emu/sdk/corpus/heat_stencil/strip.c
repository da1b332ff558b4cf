// A strip of rows of a plate. Rows at its edges are exchanged through memory, where each step has a plate of its own; a
// barrier between the SPEs is a counter in memory.
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

#define SIDE 32
#define STRIPS 4
#define ROWS (SIDE / STRIPS)
#define STEPS 10

static float rows[ROWS + 2][SIDE] __attribute__((aligned(128)));
static float fresh[ROWS][SIDE] __attribute__((aligned(128)));
static volatile unsigned int line[32] __attribute__((aligned(128)));

static void arrive(unsigned long long counter, unsigned int want) {
  do {
    mfc_getllar(line, counter, 0, 0);
    mfc_read_atomic_status();
    line[0]++;
    mfc_putllc(line, counter, 0, 0);
  } while (mfc_read_atomic_status() & MFC_PUTLLC_STATUS);
  do {
    mfc_getllar(line, counter, 0, 0);
    mfc_read_atomic_status();
  } while (line[0] < want);
}

int main(unsigned long long spe, unsigned long long plates, unsigned long long strip) {
  const unsigned int bytes = SIDE * SIDE * sizeof(float), row_bytes = SIDE * sizeof(float);
  const unsigned long long counter = plates + 2 * bytes;
  (void)spe;
  mfc_write_tag_mask(1);
  for (unsigned int step = 0; step < STEPS; step++) {
    const unsigned long long from = plates + (step & 1) * bytes, to = plates + (~step & 1) * bytes;
    const unsigned int first = strip * ROWS;
    for (unsigned int i = 0; i < ROWS + 2; i++) {
      const unsigned int row = (first + i + SIDE - 1) % SIDE;
      mfc_get(rows[i], from + row * row_bytes, row_bytes, 0, 0, 0);
    }
    mfc_read_tag_status_all();
    for (unsigned int i = 0; i < ROWS; i++) {
      for (unsigned int j = 0; j < SIDE; j++) {
        const float around = rows[i][j] + rows[i + 2][j] + rows[i + 1][(j + 1) % SIDE] + rows[i + 1][(j + SIDE - 1) % SIDE];
        fresh[i][j] = 0.5f * rows[i + 1][j] + 0.125f * around;
      }
    }
    mfc_put(fresh, to + first * row_bytes, sizeof fresh, 0, 0, 0);
    mfc_barrier(0);
    mfc_read_tag_status_all();
    arrive(counter, STRIPS * (step + 1));
  }
  return 0;
}
