#include <libspe2.h>
#include <simdmath.h>
#include <stdio.h>
#include "special.h"

extern spe_program_handle_t special;
static results theirs __attribute__((aligned(128)));
static results mine __attribute__((aligned(128)));
static const char *names[] = {"erf", "erfc", "lgamma", "tgamma"};

static void compute(void) {
  vec_float4 x = {0.5f, 2.25f, -1.5f, 6.0f};
  union {
    double element[2];
    vec_double2 both;
  } d = {{-3.75, 9.5}};
  *(vec_float4 *)mine.floats[0] = erff4(x);
  *(vec_float4 *)mine.floats[1] = erfcf4(x);
  *(vec_float4 *)mine.floats[2] = lgammaf4(x);
  *(vec_float4 *)mine.floats[3] = tgammaf4(x);
  *(vec_double2 *)mine.doubles[0] = erfd2(d.both);
  *(vec_double2 *)mine.doubles[1] = erfcd2(d.both);
  *(vec_double2 *)mine.doubles[2] = lgammad2(d.both);
  *(vec_double2 *)mine.doubles[3] = tgammad2(d.both);
}

int main(void) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  int i, j;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe == NULL || spe_program_load(spe, &special) != 0) return 1;
  if (spe_context_run(spe, &entry, 0, &theirs, NULL, NULL) != 0) return 1;
  compute();
  for (i = 0; i < 4; i++) {
    for (j = 0; j < 4; j++) printf("%s %.5g %.5g\n", names[i], theirs.floats[i][j], mine.floats[i][j]);
    for (j = 0; j < 2; j++) printf("%s %.13g %.13g\n", names[i], theirs.doubles[i][j], mine.doubles[i][j]);
  }
  return spe_context_destroy(spe);
}
