#include <libspe2.h>
#include <stdint.h>
#include <stdio.h>

#include "job.h"

extern spe_program_handle_t scale_spu;
int check(const float *in, const float *out, float offset);

static float in[COUNT] __attribute__((aligned(128)));
static float out[COUNT] __attribute__((aligned(128)));
static job_t job __attribute__((aligned(128)));

int main(void) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  int i;

  for (i = 0; i < COUNT; i++) in[i] = (float)i;
  job.in = (uintptr_t)in;
  job.out = (uintptr_t)out;
  job.bytes = sizeof in;
  job.offset = 3.0f;
  if (spe == NULL || spe_program_load(spe, &scale_spu) != 0) {
    perror("spe");
    return 1;
  }
  if (spe_context_run(spe, &entry, 0, &job, NULL, NULL) != 0) {
    perror("spe_context_run");
    return 1;
  }
  spe_context_destroy(spe);
  printf("%d wrong of %d; the last is %g\n", check(in, out, job.offset), COUNT, out[COUNT - 1]);
  return 0;
}
