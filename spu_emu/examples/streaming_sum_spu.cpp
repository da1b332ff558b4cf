// SPU side of the streaming sum: two buffers, one being filled while the other is summed.
#include <free_align.h>
#include <malloc_align.h>
#include <spu_mfcio.h>

#include "streaming_sum.h"

namespace {

void wait_for(unsigned int tag) {
  mfc_write_tag_mask(1U << tag);
  mfc_read_tag_status_all();
}

std::uint32_t sum_of(const std::uint32_t* words) {
  std::uint32_t sum = 0;
  for (std::uint32_t i = 0; i < kBlockWords; ++i) sum += words[i];
  return sum;
}

}  // namespace

int main(unsigned long long, unsigned long long argp, unsigned long long) {
  constexpr unsigned int kBlockBytes = kBlockWords * sizeof(std::uint32_t);
  auto* job = static_cast<StreamingSum*>(_malloc_align(sizeof(StreamingSum), 7));
  mfc_get(job, argp, sizeof(StreamingSum), 2, 0, 0);
  wait_for(2);

  std::uint32_t* buffers[2];
  for (auto& buffer : buffers) buffer = static_cast<std::uint32_t*>(_malloc_align(kBlockBytes, 7));
  const unsigned long long data = mfc_hl2ea(job->data_high, job->data_low);
  std::uint32_t sum = 0;
  if (job->blocks != 0) mfc_get(buffers[0], data, kBlockBytes, 0, 0, 0);
  for (std::uint32_t block = 0; block < job->blocks; ++block) {
    const unsigned int now = block & 1U;
    const unsigned int next = now ^ 1U;
    if (block + 1 < job->blocks)
      mfc_get(buffers[next], data + (block + 1ULL) * kBlockBytes, kBlockBytes, next, 0, 0);
    wait_for(now);
    sum += sum_of(buffers[now]);
  }

  job->sum = sum;
  mfc_put(job, argp, sizeof(StreamingSum), 2, 0, 0);
  wait_for(2);
  for (auto* buffer : buffers) _free_align(buffer);
  _free_align(job);
  return 0;
}
