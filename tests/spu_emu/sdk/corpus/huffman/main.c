#include <libspe2.h>
#include <stdio.h>
#include <libmisc.h>
#include "tree.h"
extern spe_program_handle_t tree_spu;


static int run(void *argp, void *envp) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe == NULL || spe_program_load(spe, &tree_spu) != 0) return -1;
  if (spe_context_run(spe, &entry, 0, argp, envp, &stop) != 0) return -2;
  spe_context_destroy(spe);
  return stop.result.spe_exit_code;
}

int main() {
  struct tree *tree = calloc_align(1, sizeof *tree, 7);
  unsigned int i, j, bits = 0, kraft = 0;
  long size = 0;
  int code;
  for (i = 0; i < 8; i++) {
    for (j = 0; j < (i * i + 1) / 1 && size < 200; j++) tree->text[size++] = 'a' + i;
  }
  code = run(tree, (void *)size);
  for (i = 0; i < 8; i++) {
    printf("%c %2u times, %u bits\n", 'a' + i, tree->count[i], tree->length[i]);
    bits += tree->count[i] * tree->length[i];
    kraft += 128 >> tree->length[i];
  }
  printf("%ld letters, %u bits, code %d, tree %s\n", size, bits, code, kraft == 128 ? "whole" : "BROKEN");
  free_align(tree);
  return 0;
}
