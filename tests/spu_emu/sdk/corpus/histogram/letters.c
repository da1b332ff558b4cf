#include <ctype.h>
#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t count;
static struct {
  char text[4096];
  unsigned int counts[256];
} block __attribute__((aligned(128)));

int main(void) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  int c, size = 0, most = 'a';
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  while (size < 4096 && (c = getchar()) != EOF) block.text[size++] = tolower(c);
  spe_program_load(spe, &count);
  if (spe_context_run(spe, &entry, 0, &block, (void *)size, NULL)) return 1;
  for (c = 'a'; c <= 'z'; c++) {
    if (block.counts[c]) printf("%c%u ", c, block.counts[c]);
    if (block.counts[c] > block.counts[most]) most = c;
  }
  printf("\n%d bytes, most often %c\n", size, most);
  return 0;
}
