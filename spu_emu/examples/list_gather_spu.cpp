// SPU side of the list gather: one list command collects records scattered in memory; it stalls half way, so
// that the first half can be sent back while the second half arrives.
#include <malloc_align.h>
#include <spu_mfcio.h>

#include "list_gather.h"

namespace {

void wait_for(unsigned int tag) {
  mfc_write_tag_mask(1U << tag);
  mfc_read_tag_status_all();
}

}  // namespace

int main(unsigned long long, unsigned long long argp, unsigned long long) {
  constexpr unsigned int kTag = 5;
  constexpr unsigned int kHalf = kRecords / 2;
  auto* job = static_cast<ListGather*>(_malloc_align(sizeof(ListGather), 7));
  mfc_get(job, argp, sizeof(ListGather), kTag, 0, 0);
  wait_for(kTag);

  auto* list = static_cast<mfc_list_element_t*>(_malloc_align(kRecords * sizeof(mfc_list_element_t), 3));
  for (std::uint32_t i = 0; i < kRecords; ++i) {
    list[i].notify = i == kHalf - 1 ? 1 : 0;
    list[i].reserved = 0;
    list[i].size = kRecordBytes;
    list[i].eal = job->table_low + job->picks[i] * kRecordBytes;
  }
  auto* records = static_cast<unsigned char*>(_malloc_align(kRecords * kRecordBytes, 7));
  mfc_getl(records, mfc_hl2ea(job->table_high, 0), list, kRecords * sizeof(mfc_list_element_t), kTag, 0, 0);
  if ((mfc_read_list_stall_status() & (1U << kTag)) == 0) return 1;

  const unsigned long long result = mfc_hl2ea(job->result_high, job->result_low);
  mfc_put(records, result, kHalf * kRecordBytes, kTag + 1, 0, 0);
  mfc_write_list_stall_ack(kTag);
  wait_for(kTag);
  mfc_put(records + kHalf * kRecordBytes, result + kHalf * kRecordBytes, kHalf * kRecordBytes, kTag + 1, 0,
          0);
  wait_for(kTag + 1);
  return 0;
}
