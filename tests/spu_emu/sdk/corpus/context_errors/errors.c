/* What the library refuses, and by which error: a host program without any SPU program. */
#include <errno.h>
#include <libspe2.h>
#include <stdio.h>
#include <string.h>

static void said(const char *what, int failed)
{
  printf("%s: %s\n", what, failed ? strerror(errno) : "no error");
}

int main()
{
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  unsigned int word;
  printf("SPEs: %d\n", spe_cpu_info_get(SPE_COUNT_PHYSICAL_SPES, -1) >= 1);
  said("image", spe_image_open("nowhere.elf") == NULL);
  said("may not be executed", spe_image_open("Makefile") == NULL);
  said("destroy", spe_context_destroy(NULL));
  said("mailbox", spe_out_mbox_read(spe, &word, 0) < 0);
  said("signal", spe_signal_write(spe, 7, 1) < 0);
  printf("empty mailbox: %d words\n", spe_out_mbox_read(spe, &word, 1));
  printf("places: %d\n", spe_in_mbox_status(spe));
  said("end", spe_context_destroy(spe));
  return 0;
}
