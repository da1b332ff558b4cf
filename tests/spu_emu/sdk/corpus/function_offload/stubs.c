#include "frame.h"

#include <libspe2.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

extern spe_program_handle_t offloaded_functions;

static struct frame frame;
static spe_context_ptr_t spe;
static unsigned int entry = SPE_DEFAULT_ENTRY;

static int go_on(void) {
  spe_stop_info_t stop;
  if (spe == NULL) {
    spe = spe_context_create(0, NULL);
    if (spe == NULL || spe_program_load(spe, &offloaded_functions) != 0) exit(1);
  }
  if (spe_context_run(spe, &entry, 0, &frame, NULL, &stop) < 0) exit(2);
  return stop.stop_reason == SPE_STOP_AND_SIGNAL ? stop.result.spe_signal_code : 0;
}

static float call(unsigned int function) {
  frame.function = function;
  if (go_on() != STOP_NEXT) exit(3);
  return frame.result;
}

float dot(const float *a, const float *b, unsigned int count) {
  frame.vectors[0] = (uintptr_t)a;
  frame.vectors[1] = (uintptr_t)b;
  frame.count = count;
  return call(FUNCTION_DOT);
}

float polynomial(float x, const float *coefficients, unsigned int count) {
  frame.argument = x;
  frame.vectors[0] = (uintptr_t)coefficients;
  frame.count = count;
  return call(FUNCTION_POLYNOMIAL);
}

void end_of_calls(void) {
  frame.function = 0;
  if (go_on() != 0) exit(4);
  spe_context_destroy(spe);
}
