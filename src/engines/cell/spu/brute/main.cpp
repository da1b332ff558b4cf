// SPU program of cell-brute: every changed body of its share against all bodies, four at a time.
#include <free_align.h>
#include <malloc_align.h>
#include <spu_intrinsics.h>

#include "engines/cell/spu/brute/overlap_row.h"
#include "engines/cell/spu/common/dma.h"
#include "engines/cell/wire.h"

namespace {

using namespace cellsweep::cell;

constexpr unsigned int kLog2Align = 7;
constexpr unsigned int kInTag = 2;

void* allocate(unsigned int bytes) {
  return _malloc_align(bytes, kLog2Align);
}

// Two row buffers take turns, so that one is on its way while the other is filled.
void test_share(const BruteJob& job, const vec_float4* boxes, const std::uint32_t* changed) {
  const unsigned int row_bytes = job.bodies / 8;
  std::uint32_t* rows[2] = {static_cast<std::uint32_t*>(allocate(row_bytes)),
                            static_cast<std::uint32_t*>(allocate(row_bytes))};
  unsigned long long ea = ea_of(job.rows);
  for (std::uint32_t i = 0; i < job.count; ++i, ea += row_bytes) {
    const unsigned int turn = i & 1U;
    wait_for_tag(turn);
    overlap_row(boxes, job.bodies, changed[i], rows[turn]);
    put_all(rows[turn], ea, row_bytes, turn);
  }
  wait_for_tags(3);
  _free_align(rows[1]);
  _free_align(rows[0]);
}

}  // namespace

int main(unsigned long long, unsigned long long argp, unsigned long long) {
  auto* job = static_cast<BruteJob*>(allocate(sizeof(BruteJob)));
  get_all(job, argp, sizeof(BruteJob), kInTag);
  wait_for_tag(kInTag);
  const unsigned int box_bytes = 6 * 4 * job->bodies;
  const unsigned int changed_bytes = dma_bytes(job->count);
  auto* boxes = static_cast<vec_float4*>(allocate(box_bytes));
  auto* changed = static_cast<std::uint32_t*>(allocate(changed_bytes));
  get_all(boxes, ea_of(job->boxes), box_bytes, kInTag);
  get_all(changed, ea_of(job->changed), changed_bytes, kInTag);
  wait_for_tag(kInTag);
  test_share(*job, boxes, changed);
  _free_align(changed);
  _free_align(boxes);
  _free_align(job);
  return 0;
}
