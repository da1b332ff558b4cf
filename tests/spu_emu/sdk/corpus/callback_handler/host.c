#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t asks;
static int calls;

/* The word after the stop has the operation in its upper 8 bits and the address of the arguments below. */
static int add(void *local_store, unsigned int where) {
  unsigned int word = *(unsigned int *)((char *)local_store + where);
  unsigned int *sum = (unsigned int *)((char *)local_store + (word & 0x3ffff));
  if (word >> 24 != 1) return 1;
  sum[2] = sum[0] + sum[1];
  printf("%u + %u = %u\n", sum[0], sum[1], sum[2]);
  calls++;
  return 0;
}

int main() {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe_callback_handler_register(add, 0x10, SPE_CALLBACK_NEW)) return 1;
  printf("registered %d, again %d\n", spe_callback_handler_query(0x10) == (void *)add,
         spe_callback_handler_register(add, 0x10, SPE_CALLBACK_NEW));
  spe_program_load(spe, &asks);
  if (spe_context_run(spe, &entry, 0, NULL, NULL, &stop)) return 1;
  spe_callback_handler_deregister(0x10);
  printf("%d calls, exit code %d\n", calls, stop.result.spe_exit_code);
  return spe_context_destroy(spe);
}
