// Evaluates a function of the SIMD math library on batches of arguments.
#include <spu_mfcio.h>

#include "simdmath/evaluate.h"
#include "simdmath/job.h"

namespace {

using simdmath_test::kArguments;
using simdmath_test::kResults;
using simdmath_test::Register;

void wait_for_transfers() {
  mfc_write_tag_mask(1);
  mfc_read_tag_status_all();
}

Register in[kBatch * kArguments] __attribute__((aligned(128)));
Register out[kBatch * kResults] __attribute__((aligned(128)));

}  // namespace

int main(unsigned long long, unsigned long long argp, unsigned long long) {
  SimdmathJob job __attribute__((aligned(16)));
  mfc_get(&job, argp, sizeof job, 0, 0, 0);
  wait_for_transfers();
  if (job.function >= sizeof simdmath_test::evaluators / sizeof *simdmath_test::evaluators) return 1;
  unsigned long long input = mfc_hl2ea(job.input_hi, job.input_lo);
  unsigned long long output = mfc_hl2ea(job.output_hi, job.output_lo);
  for (unsigned batch = 0; batch < job.batches; ++batch, input += sizeof in, output += sizeof out) {
    mfc_get(in, input, sizeof in, 0, 0, 0);
    wait_for_transfers();
    for (unsigned i = 0; i < kBatch; ++i) {
      out[i * kResults] = out[i * kResults + 1] = Register();
      simdmath_test::evaluators[job.function](in + i * kArguments, out + i * kResults);
    }
    mfc_put(out, output, sizeof out, 0, 0, 0);
    wait_for_transfers();
  }
  return 0;
}
