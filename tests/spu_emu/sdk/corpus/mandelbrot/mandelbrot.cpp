#include <libspe2.h>
#include <pthread.h>

#include <cstdio>
#include <cstdlib>

#include "job.h"

extern "C" spe_program_handle_t rows_spu;

static volatile unsigned int counter[32] __attribute__((aligned(128)));
static char image[256 * 64] __attribute__((aligned(128)));
static Job job;

static void* run(void* code) {
  spe_context_ptr_t spe = spe_context_create(0, 0);
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  spe_program_load(spe, &rows_spu);
  if (spe_context_run(spe, &entry, 0, &job, 0, &stop) != 0) std::exit(1);
  *(int*)code = stop.result.spe_exit_code;
  spe_context_destroy(spe);
  return 0;
}

int main(int argc, char** argv) {
  if (argc != 4) {
    std::printf("usage: %s WIDTH HEIGHT LIMIT\n", argv[0]);
    return 2;
  }
  job.counter = (unsigned long)counter;
  job.image = (unsigned long)image;
  job.width = std::atoi(argv[1]) / 16 * 16;
  job.height = std::atoi(argv[2]);
  job.limit = std::atoi(argv[3]);
  pthread_t threads[3];
  int rows[3], sum = 0;
  for (int i = 0; i < 3; ++i) pthread_create(&threads[i], 0, run, &rows[i]);
  for (int i = 0; i < 3; ++i) pthread_join(threads[i], 0), sum += rows[i];
  for (int j = 0; j < job.height; ++j) std::printf("%.*s|\n", job.width, image + j * job.width);
  std::printf("%d rows\n", sum);
}
