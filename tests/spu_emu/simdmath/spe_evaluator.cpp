#include "simdmath/spe_evaluator.h"

#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "simdmath/job.h"

namespace simdmath_test {

namespace {

struct Free {
  void operator()(void* block) const { std::free(block); }
};
using Memory = std::unique_ptr<unsigned char[], Free>;

Memory lines(std::size_t size) {
  return Memory(static_cast<unsigned char*>(std::aligned_alloc(128, (size + 127) / 128 * 128)));
}

unsigned high(const void* pointer) {
  return static_cast<unsigned>(reinterpret_cast<std::uintptr_t>(pointer) >> 32U);
}
unsigned low(const void* pointer) {
  return static_cast<unsigned>(reinterpret_cast<std::uintptr_t>(pointer));
}

}  // namespace

std::vector<Result> evaluate_on_spe(spe_program_handle_t& program, unsigned function,
                                    const std::vector<Call>& calls) {
  const std::size_t batches = (calls.size() + kBatch - 1) / kBatch;
  const Memory input = lines(batches * kBatch * sizeof(Call));
  const Memory output = lines(batches * kBatch * sizeof(Result));
  std::memset(input.get(), 0, batches * kBatch * sizeof(Call));
  std::memcpy(input.get(), calls.data(), calls.size() * sizeof(Call));
  alignas(128) SimdmathJob job{function,          static_cast<unsigned>(batches), high(input.get()), low(input.get()),
                               high(output.get()), low(output.get()),              {}};
  spe_context_ptr_t spe = spe_context_create(0, nullptr);
  spe_stop_info_t stop{};
  unsigned entry = SPE_DEFAULT_ENTRY;
  const bool ran = spe != nullptr && spe_program_load(spe, &program) == 0 &&
                   spe_context_run(spe, &entry, 0, &job, nullptr, &stop) == 0 && stop.stop_reason == SPE_EXIT &&
                   stop.result.spe_exit_code == 0;
  if (spe != nullptr) spe_context_destroy(spe);
  if (!ran) throw std::runtime_error("the SPU program has other functions or broke a rule");
  std::vector<Result> results(calls.size());
  std::memcpy(results.data(), output.get(), results.size() * sizeof(Result));
  return results;
}

}  // namespace simdmath_test
