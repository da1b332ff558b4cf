#include <libspe2.h>
#include <ppu_intrinsics.h>
#include <stdio.h>

extern spe_program_handle_t clock_spu;

int main() {
  unsigned int entry = SPE_DEFAULT_ENTRY;
  unsigned long long begin = __mftb();
  spe_context_ptr_t spe = spe_context_create(0, NULL);
  spe_program_load(spe, &clock_spu);
  if (spe_context_run(spe, &entry, 0, 0, 0, 0)) return 1;
  printf("%s\n", __mftb() > begin ? "time passed" : "NO TIME");
  return 0;
}
