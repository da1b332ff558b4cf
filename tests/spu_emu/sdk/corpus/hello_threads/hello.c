#include <errno.h>
#include <libspe2.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

#define MAX_SPES 8

extern spe_program_handle_t hello_spu;

typedef struct {
  spe_context_ptr_t spe;
  unsigned long argp;
  int code;
} thread_data;

static void *run_spe(void *arg) {
  thread_data *data = (thread_data *)arg;
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t info;
  if (spe_context_run(data->spe, &entry, 0, (void *)data->argp, NULL, &info) < 0) {
    perror("spe_context_run");
    exit(1);
  }
  data->code = info.result.spe_exit_code;
  pthread_exit(NULL);
}

int main(void) {
  pthread_t threads[MAX_SPES];
  thread_data data[MAX_SPES];
  int i, spes = spe_cpu_info_get(SPE_COUNT_USABLE_SPES, -1), sum = 0;

  if (spes > MAX_SPES) spes = MAX_SPES;
  for (i = 0; i < spes; i++) {
    if ((data[i].spe = spe_context_create(0, NULL)) == NULL) {
      perror("spe_context_create");
      return 1;
    }
    if (spe_program_load(data[i].spe, &hello_spu)) {
      perror("spe_program_load");
      return 1;
    }
    data[i].argp = (unsigned long)(spes << 8 | i);
    if (pthread_create(&threads[i], NULL, run_spe, &data[i])) return 1;
    /* One after the other: what they print is to be in order. */
    pthread_join(threads[i], NULL);
    sum += data[i].code;
    spe_context_destroy(data[i].spe);
  }
  printf("%d bits, exit codes add up to %d\n", (int)sizeof(void *) * 8, sum);
  return 0;
}
