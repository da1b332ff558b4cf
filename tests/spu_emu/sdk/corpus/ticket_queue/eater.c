#include <spu_mfcio.h>

#include "queue.h"

static volatile queue_t queue;

// The next item, or 0 after the last.
static unsigned int take(unsigned long long ea) {
  for (;;) {
    mfc_getllar(&queue, ea, 0, 0);
    mfc_read_atomic_status();
    if (queue.lock != 0 || queue.head == queue.tail) continue;
    const unsigned int item = queue.items[queue.head % PLACES];
    if (item == 0) return 0; /* stays for the others */
    queue.head++;
    mfc_putllc(&queue, ea, 0, 0);
    if ((mfc_read_atomic_status() & MFC_PUTLLC_STATUS) == 0) return item;
  }
}

int main(unsigned long long spe, unsigned long long ea) {
  unsigned int sum = 0, item;
  (void)spe;
  while ((item = take(ea)) != 0) sum += item * item;
  spu_write_out_mbox(sum);
  return 0;
}
