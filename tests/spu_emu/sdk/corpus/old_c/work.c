#include <spu_mfcio.h>

int table[32] __attribute__((aligned(128)));

square(x)
     int x;
{
  return x * x;
}

main(speid, argp, envp)
     unsigned long long speid, argp, envp;
{
  int i;
  mfc_get(table, argp, 128, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  for (i = 0; i < 32; i++)
    table[i] = square(table[i]);
  mfc_put(table, argp, 128, 0, 0, 0);
  mfc_read_tag_status_all();
  return 0;
}
