#include <spu_mfcio.h>

#include "phases.h"

void read_values(unsigned long long ea) {
  mfc_get(values, ea, sizeof values, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
}
