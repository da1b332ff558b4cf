// Streams a job's bytes into the local store, one transfer at a time, and waits for each; stops to be timed.
#include <malloc_align.h>
#include <spu_mfcio.h>

#include "bench_dma.h"

int main(unsigned long long, unsigned long long argp, unsigned long long) {
  auto* job = static_cast<DmaJob*>(_malloc_align(sizeof(DmaJob), 7));
  auto* buffer = static_cast<char*>(_malloc_align(16384, 12));
  mfc_write_tag_mask(1);
  mfc_get(job, argp, sizeof(DmaJob), 0, 0, 0);
  mfc_read_tag_status_all();
  for (;;) {
    const auto transfer = static_cast<unsigned int>(job->transfer);
    for (unsigned long long done = 0; done < job->bytes; done += transfer) {
      mfc_get(buffer, job->source + done, transfer, 0, 0, 0);
      mfc_read_tag_status_all();
    }
    spu_stop(1);
  }
}
