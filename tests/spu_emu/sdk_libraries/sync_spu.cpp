// Waits until it may begin, then counts: alone by an atomic counter, and by a word that a mutex guards.
#include <libsync.h>
#include <spu_mfcio.h>

#include "sdk_libraries/shared.h"

namespace {

SharedWord word __attribute__((aligned(128)));

void transfer(bool is_put, unsigned long long address) {
  if (is_put) {
    mfc_put(&word, address, sizeof word, 0, 0, 0);
  } else {
    mfc_get(&word, address, sizeof word, 0, 0, 0);
  }
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
}

}  // namespace

int main(unsigned long long, unsigned long long argp, unsigned long long) {
  SharedJob job __attribute__((aligned(16)));
  mfc_get(&job, argp, sizeof job, 0, 0, 0);
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
  const unsigned long long state = mfc_hl2ea(job.state_hi, job.state_lo);
  const auto at = [state](unsigned place) { return state + place * sizeof(SharedWord); };

  mutex_lock(at(1));
  for (transfer(false, at(6)); word.value == 0; transfer(false, at(6))) cond_wait(at(2), at(1));
  mutex_unlock(at(1));
  for (int i = 0; i < kRounds; ++i) {
    atomic_inc(at(0));
    mutex_lock(at(1));
    transfer(false, at(5));
    ++word.value;
    transfer(true, at(5));
    mutex_unlock(at(1));
    read_lock(at(4));
    read_unlock(at(4));
  }
  complete(at(3));
  return 0;
}
