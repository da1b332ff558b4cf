#include <libspe2.h>
#include <stdio.h>

extern "C" spe_program_handle_t poll;
static int data[4][1024] __attribute__((aligned(128)));

int main(int argc, char **argv, char **envp)
{
  unsigned int entry = SPE_DEFAULT_ENTRY, word = 0;
  spe_stop_info_t stop;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  for (int i = 0; i < 4096; i++) data[0][i] = i;
  spe_program_load(spe, &poll);
  spe_context_run(spe, &entry, 0, data, NULL, &stop);
  spe_out_mbox_read(spe, &word, 1);
  printf("queue %u, sum mod 200 is %d, first words %d %d %d %d\n", word, stop.result.spe_exit_code, data[0][0], data[1][0],
         data[2][0], data[3][0]);
  return spe_context_destroy(spe);
}
