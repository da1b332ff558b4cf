#include <libspe2.h>
#include <stdio.h>
#include <string.h>
extern spe_program_handle_t horspool;
static struct {
  char pattern[64];
  char text[1024];
} block __attribute__((aligned(128))) = {"", "the quick brown fox jumps over the lazy dog; the ox and the cat saw the other cats in the box"};

int main(int argc, char *argv[]) {
  int i;
  for (i = 1; i < argc; i++) {
    unsigned int entry = SPE_DEFAULT_ENTRY, first;
    spe_stop_info_t stop;
    spe_context_ptr_t spe = spe_context_create(0, NULL);
    strncpy(block.pattern, argv[i], sizeof block.pattern - 1);
    spe_program_load(spe, &horspool);
    if (spe_context_run(spe, &entry, 0, &block, (void *)strlen(block.text), &stop)) return 1;
    printf("%s: %d times", argv[i], stop.result.spe_exit_code);
    if (spe_out_mbox_read(spe, &first, 1) == 1) printf(", first at %u", first);
    putchar('\n');
    spe_context_destroy(spe);
  }
  return 0;
}
