#include <libspe2.h>
#include "globals.h"

extern spe_program_handle_t work;

run_work(table)
     int *table;
{
  unsigned int entry = SPE_DEFAULT_ENTRY;
  spe_context_ptr_t spe;
  calls++;
  spe = spe_context_create(0, 0);
  spe_program_load(spe, &work);
  return spe_context_run(spe, &entry, 0, table, 0, 0);
}
