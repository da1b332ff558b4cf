#include <libsync.h>
#include <spu_mfcio.h>
#include <stddef.h>

#include "bank.h"

static int balance[ACCOUNTS] __attribute__((aligned(128)));

static void move(unsigned long long bank, unsigned int cmd) {
  spu_mfcdma64(balance, mfc_ea2h(bank), mfc_ea2l(bank), sizeof balance, 2, cmd);
  mfc_write_tag_mask(1 << 2);
  mfc_read_tag_status_all();
}

int main(unsigned long long spe, unsigned long long bank, unsigned long long seed) {
  unsigned int random = (unsigned int)seed, i;
  (void)spe;
  for (i = 0; i < TRANSFERS; i++) {
    unsigned int from, to;
    random = random * 1103515245 + 12345;
    from = random >> 16 & (ACCOUNTS - 1);
    to = random >> 24 & (ACCOUNTS - 1);
    mutex_lock(bank + offsetof(bank_t, mutex));
    move(bank, MFC_GET_CMD);
    balance[from] -= 5;
    balance[to] += 5;
    move(bank, MFC_PUT_CMD);
    mutex_unlock(bank + offsetof(bank_t, mutex));
  }
  atomic_add(TRANSFERS, bank + offsetof(bank_t, total));
  complete(bank + offsetof(bank_t, done));
  return 0;
}
