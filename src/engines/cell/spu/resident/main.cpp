// SPU program of cell-resident: stays alive, waits for orders in its mailbox (F4), answers each when it is
// done.
#include <free_align.h>
#include <malloc_align.h>
#include <spu_intrinsics.h>

#include "engines/cell/resident_wire.h"
#include "engines/cell/spu/common/dma.h"
#include "engines/cell/spu/resident/resident_spu.h"

namespace {

using namespace cellsweep::cell;

constexpr unsigned int kLog2Align = 7;
constexpr unsigned int kJobTag = 2;

ResidentJob fetch_job(unsigned long long ea) {
  auto* buffer = static_cast<ResidentJob*>(_malloc_align(sizeof(ResidentJob), kLog2Align));
  get_all(buffer, ea, sizeof(ResidentJob), kJobTag);
  wait_for_tag(kJobTag);
  const ResidentJob job = *buffer;
  _free_align(buffer);
  return job;
}

}  // namespace

int main(unsigned long long, unsigned long long argp, unsigned long long) {
  ResidentSpu spu(fetch_job(argp));
  spu_write_out_intr_mbox(0);
  for (;;) {
    const unsigned int word = spu_read_in_mbox();
    const auto order = static_cast<ResidentOrder>(word & ((1U << kResidentOrderBits) - 1));
    if (order == ResidentOrder::stop) return 0;
    spu_write_out_intr_mbox(spu.obey(order, word >> kResidentOrderBits));
  }
}
