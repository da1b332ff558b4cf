#include "bindings/c/options.h"

#include <new>

namespace cellsweep::c {

CallersExecutor::~CallersExecutor() {
  if (is_kept_ && callers_.release != nullptr) callers_.release(callers_.context);
}

void CallersExecutor::run(unsigned count, Task task, void* context) {
  if (!callers_.run(callers_.context, count, task, context)) throw std::bad_alloc();
}

Result<std::shared_ptr<CallersExecutor>> executor_of(const cellsweep_executor* callers) {
  if (callers == nullptr) return std::shared_ptr<CallersExecutor>();
  if (callers->run == nullptr || callers->concurrency == 0) {
    return Status::bad_option("executor",
                              "An executor needs a function `run` and a `concurrency` of 1 or more.");
  }
  return std::make_shared<CallersExecutor>(*callers);
}

Result<VectorIsa> isa_of(std::uint32_t isa) {
  switch (isa) {
    case CELLSWEEP_ISA_BEST:
      return VectorIsa::best;
    case CELLSWEEP_ISA_PORTABLE:
      return VectorIsa::portable;
    case CELLSWEEP_ISA_SSE41:
      return VectorIsa::sse41;
    case CELLSWEEP_ISA_AVX2:
      return VectorIsa::avx2;
    case CELLSWEEP_ISA_AVX512:
      return VectorIsa::avx512;
  }
  return Status::bad_option("isa", text("There is no instruction set ", isa, "; 0 is the best."));
}

}  // namespace cellsweep::c
