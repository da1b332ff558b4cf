/// @file
/// Settings from C: structs that know their size, executors, instruction sets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>

#include "base/text.h"
#include "cellsweep/c/broadphase.h"
#include "cellsweep/executor.h"
#include "cellsweep/status.h"
#include "cellsweep/vector_isa.h"

namespace cellsweep::c {

/// An executor of the caller's. It is released only after keep(), so that a call that fails keeps nothing.
class CallersExecutor final : public Executor {
 public:
  explicit CallersExecutor(const cellsweep_executor& callers) : callers_(callers) {}
  CallersExecutor(const CallersExecutor&) = delete;
  CallersExecutor& operator=(const CallersExecutor&) = delete;
  ~CallersExecutor() override;

  void keep() { is_kept_ = true; }

  unsigned concurrency() const override { return callers_.concurrency; }
  void run(unsigned count, Task task, void* context) override;

 private:
  cellsweep_executor callers_;
  bool is_kept_ = false;
};

/// Null for null. Errors: bad_option for one that cannot run anything.
Result<std::shared_ptr<CallersExecutor>> executor_of(const cellsweep_executor* callers);

/// Errors: bad_option for a number that is none.
Result<VectorIsa> isa_of(std::uint32_t isa);

/// The caller's options; all zeros for null. Errors: bad_option for a size that no version of the struct has
/// had.
template <class Options>
Status read_options(const Options* from, Options& options) {
  options = {};
  if (from == nullptr) return {};
  if (from->size != sizeof(Options)) {
    return Status::bad_option("size",
                              text("The options' `size` is ", from->size, ", but the struct has ",
                                   sizeof(Options), " bytes; set it to sizeof of the struct."),
                              from->size, sizeof(Options));
  }
  options = *from;
  return {};
}

}  // namespace cellsweep::c
