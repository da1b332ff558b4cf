// y = A x, where each row's elements of x are gathered by a list; tags come from the tag manager.
#include <spu_mfcio.h>
#include <stddef.h>

#include "rows.h"

static struct matrix m __attribute__((aligned(128)));
static mfc_list_element_t list[2][PER_ROW] __attribute__((aligned(8)));
static float gathered[2][PER_ROW][4] __attribute__((aligned(128)));
static unsigned int tags;

static void gather(unsigned long long ea, int row) {
  const int b = row & 1;
  for (int k = 0; k < PER_ROW; k++) {
    list[b][k].notify = 0;
    list[b][k].reserved = 0;
    list[b][k].size = 16;
    list[b][k].eal = mfc_ea2l(ea) + offsetof(struct matrix, x) + m.columns[row][k] * 16;
  }
  mfc_getl(gathered[b], ea, list[b], sizeof list[b], tags + b, 0, 0);
}

int main(unsigned long long spe, unsigned long long ea, unsigned long long envp) {
  (void)spe;
  (void)envp;
  tags = mfc_multi_tag_reserve(2);
  if (tags == MFC_TAG_INVALID) return 1;
  mfc_get(&m, ea, offsetof(struct matrix, x), tags, 0, 0);
  mfc_write_tag_mask(1 << tags);
  mfc_read_tag_status_all();
  gather(ea, 0);
  for (int i = 0; i < N; i++) {
    if (i + 1 < N) gather(ea, i + 1);
    mfc_write_tag_mask(1 << (tags + (i & 1)));
    mfc_read_tag_status_all();
    m.y[i] = 0;
    for (int k = 0; k < PER_ROW; k++) m.y[i] += m.values[i][k] * gathered[i & 1][k][0];
  }
  mfc_put(m.y, ea + offsetof(struct matrix, y), sizeof m.y, tags, 0, 0);
  mfc_write_tag_mask(1 << tags);
  mfc_read_tag_status_all();
  mfc_multi_tag_release(tags, 2);
  return 0;
}
