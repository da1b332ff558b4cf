// Calls a range of rows on every case of a job and puts the results row after row.
#include <spu_mfcio.h>

#include "differential/job.h"
#include "differential/row.h"

namespace {

unsigned long long address(unsigned int hi, unsigned int lo) {
  return (static_cast<unsigned long long>(hi) << 32) | lo;
}

void wait_for(unsigned tag) {
  mfc_write_tag_mask(1U << tag);
  mfc_read_tag_status_all();
}

}  // namespace

int main(unsigned long long, unsigned long long argp, unsigned long long) {
  DifferentialJob job __attribute__((aligned(16)));
  vec_uint4 in[kCases * kInputsPerCase] __attribute__((aligned(128)));
  vec_uint4 out[kCases] __attribute__((aligned(128)));
  mfc_get(&job, argp, sizeof job, 0, 0, 0);
  wait_for(0);
  mfc_get(in, address(job.input_hi, job.input_lo), sizeof in, 0, 0, 0);
  wait_for(0);
  if (job.first_row > row_count || job.rows > row_count - job.first_row) return 1;
  unsigned long long output = address(job.output_hi, job.output_lo);
  for (unsigned row = job.first_row; row < job.first_row + job.rows; ++row, output += sizeof out) {
    for (unsigned i = 0; i < kCases; ++i) out[i] = rows[row](in + i * kInputsPerCase);
    mfc_put(out, output, sizeof out, 0, 0, 0);
    wait_for(0);
  }
  return 0;
}
