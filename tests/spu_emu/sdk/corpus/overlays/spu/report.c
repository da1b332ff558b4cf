#include <spu_mfcio.h>

#include "phases.h"

unsigned int report_values(unsigned long long ea) {
  mfc_put(values, ea, sizeof values, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  return values[0] == 0;
}
