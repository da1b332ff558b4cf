#include <libmisc.h>
#include <spu_mfcio.h>

#include "tree.h"

int main(unsigned long long spe, unsigned long long ea, unsigned long long size) {
  struct tree *tree = malloc_align(sizeof *tree, 7);
  int parent[2 * SYMBOLS], used[2 * SYMBOLS] = {0}, i, node, bits = 0;
  (void)spe;
  mfc_get(tree, ea, sizeof *tree, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  for (i = 0; i < 2 * SYMBOLS; i++) tree->count[i] = tree->length[i] = 0;
  for (i = 0; i < (int)size; i++) tree->count[tree->text[i] - 'a']++;
  for (node = SYMBOLS; node < 2 * SYMBOLS - 1; node++) {
    int pick, least;
    for (pick = 0; pick < 2; pick++) {
      for (least = -1, i = 0; i < node; i++) {
        if (!used[i] && (least < 0 || tree->count[i] < tree->count[least])) least = i;
      }
      used[least] = 1;
      parent[least] = node;
      tree->count[node] += tree->count[least];
    }
  }
  for (i = 2 * SYMBOLS - 3; i >= 0; i--) tree->length[i] = tree->length[parent[i]] + 1;
  for (i = 0; i < SYMBOLS; i++) bits += tree->count[i] * tree->length[i];
  copy_from_ls(ea, (unsigned int)tree, sizeof *tree);
  free_align(tree);
  return bits % 251;
}
