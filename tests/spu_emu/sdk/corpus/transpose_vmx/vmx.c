#include <libspe2.h>
#include <stdio.h>

extern spe_program_handle_t turn;
static vector unsigned int mine[4], theirs[4] __attribute__((aligned(128)));

static int run(void *argp, void *envp) {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_stop_info_t stop;
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  if (spe == NULL || spe_program_load(spe, &turn) != 0) return -1;
  if (spe_context_run(spe, &entry, 0, argp, envp, &stop) != 0) return -2;
  spe_context_destroy(spe);
  return stop.result.spe_exit_code;
}

static void transpose(vector unsigned int *rows) {
  vector unsigned int a = vec_mergeh(rows[0], rows[2]), b = vec_mergeh(rows[1], rows[3]);
  vector unsigned int c = vec_mergel(rows[0], rows[2]), d = vec_mergel(rows[1], rows[3]);
  rows[0] = vec_mergeh(a, b), rows[1] = vec_mergel(a, b);
  rows[2] = vec_mergeh(c, d), rows[3] = vec_mergel(c, d);
}

int main(void) {
  int i, equal = 1;
  for (i = 0; i < 16; i++) ((unsigned int *)mine)[i] = ((unsigned int *)theirs)[i] = i * i;
  transpose(mine);
  if (run(theirs, NULL)) return 1;
  for (i = 0; i < 4; i++) equal &= vec_all_eq(mine[i], theirs[i]);
  for (i = 0; i < 16; i++) printf("%u%c", ((unsigned int *)theirs)[i], i % 4 == 3 ? '\n' : ' ');
  printf("%s\n", equal ? "equal" : "DIFFERENT");
  return 0;
}
