/* Several tables, so that the same letter twice running needs not wait for its own store. */
#include <spu_intrinsics.h>
#include <spu_mfcio.h>

static unsigned char text[4096] __attribute__((aligned(128)));
static unsigned int tables[4][256] __attribute__((aligned(128)));

int main(unsigned long long spe __attribute__((unused)), unsigned long long ea, unsigned long long size) {
  unsigned int i;
  const unsigned long long result = ea + sizeof text;
  vec_uint4 *t = (vec_uint4 *)tables;
  mfc_get(text, ea, sizeof text, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  for (i = 0; i < size; i++) tables[i & 3][text[i]]++;
  for (i = 0; i < 64; i++) t[i] = spu_add(spu_add(t[i], t[i + 64]), spu_add(t[i + 128], t[i + 192]));
  mfc_put(tables[0], result, sizeof tables[0], 0, 0, 0);
  mfc_read_tag_status_all();
  return 0;
}
