#include <libspe2.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

#include "protocol.h"

extern spe_program_handle_t server;
static spe_context_ptr_t spe;

static void *run(void *unused) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  if (spe_context_run(spe, &entry, 0, NULL, NULL, &stop) < 0) exit(1);
  return (void *)(long)stop.result.spe_exit_code;
}

static unsigned int call(unsigned int operation, unsigned int a, unsigned int b) {
  unsigned int message[3], answer;
  message[0] = operation;
  message[1] = a;
  message[2] = b;
  spe_in_mbox_write(spe, message, 3, SPE_MBOX_ALL_BLOCKING);
  spe_out_intr_mbox_read(spe, &answer, 1, SPE_MBOX_ALL_BLOCKING);
  return answer;
}

int main(void) {
  pthread_t thread;
  unsigned int quit = QUIT, served, i, sum = 0;
  void *code;

  spe = spe_context_create(SPE_EVENTS_ENABLE, NULL);
  if (!spe || spe_program_load(spe, &server)) return 1;
  pthread_create(&thread, NULL, run, NULL);
  printf("1234567 + 7654321 = %u\n", call(ADD, 1234567, 7654321));
  printf("54321 * 12345 = %u\n", call(MULTIPLY, 54321, 12345));
  printf("the root of 2000000000 is %u\n", call(SQUARE_ROOT, 2000000000, 0));
  for (i = 0; i < 200; i++) sum += call(ADD, i, i);
  printf("200 more: %u\n", sum);
  spe_in_mbox_write(spe, &quit, 1, SPE_MBOX_ANY_NONBLOCKING);
  while (spe_out_mbox_status(spe) == 0) {
  }
  spe_out_mbox_read(spe, &served, 1);
  pthread_join(thread, &code);
  printf("served %u, exit code %ld, pointers of %d bits\n", served, (long)code, (int)sizeof code * 8);
  return 0;
}
