#include <spu_intrinsics.h>
#include <spu_mfcio.h>

// Filled with the addresses of the host's variables.
unsigned long long _EAR_table[2] __attribute__((section(".toe"), aligned(16)));
unsigned long long _EAR_total[2] __attribute__((section(".toe"), aligned(16)));

static unsigned int numbers[32] __attribute__((aligned(128)));
static unsigned int sum[4] __attribute__((aligned(16)));

int main(unsigned long long spe, unsigned long long table) {
  int i;
  (void)spe;
  mfc_get(numbers, _EAR_table[0], sizeof numbers, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  for (i = 0; i < 32; i++) sum[0] += numbers[i];
  mfc_put(sum, _EAR_total[0], sizeof sum, 0, 0, 0);
  mfc_read_tag_status_all();
  return _EAR_table[0] == table ? 0 : 1;
}
