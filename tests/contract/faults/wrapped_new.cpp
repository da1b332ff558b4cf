/// @file
/// The same for C++'s operators.
#include <cstddef>
#include <new>

#include "contract/faults/failing_calls.h"

using cellsweep::contract::must_fail;
using cellsweep::contract::Scarce;

extern "C" {

// NOLINTBEGIN: the linker's names
void* __real__Znwm(std::size_t bytes);
void* __real__ZnwmSt11align_val_t(std::size_t bytes, std::align_val_t alignment);

void* __wrap__Znwm(std::size_t bytes) {
  if (must_fail(Scarce::memory)) throw std::bad_alloc();
  return __real__Znwm(bytes);
}

void* __wrap__ZnwmSt11align_val_t(std::size_t bytes, std::align_val_t alignment) {
  if (must_fail(Scarce::memory)) throw std::bad_alloc();
  return __real__ZnwmSt11align_val_t(bytes, alignment);
}
// NOLINTEND

}  // extern "C"
