/// @file
/// What the linker gives this project's own objects in place of functions for memory and threads (--wrap), in
/// builds with sanitizers: these have the C library's names for themselves.
#include <pthread.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstdlib>
#include <new>

#include "contract/faults/failing_calls.h"

using cellsweep::contract::must_fail;
using cellsweep::contract::Scarce;

extern "C" {

// NOLINTBEGIN: the linker's names
void* __real_malloc(std::size_t bytes);
void* __real_realloc(void* memory, std::size_t bytes);
int __real_posix_memalign(void** memory, std::size_t alignment, std::size_t bytes);
void* __real_mmap(void* address, std::size_t bytes, int protection, int flags, int file, off_t offset);
void* __real__Znwm(std::size_t bytes);
void* __real__ZnwmSt11align_val_t(std::size_t bytes, std::align_val_t alignment);

void* __wrap_malloc(std::size_t bytes) {
  return must_fail(Scarce::memory) ? nullptr : __real_malloc(bytes);
}

void* __wrap_realloc(void* memory, std::size_t bytes) {
  return must_fail(Scarce::memory) ? nullptr : __real_realloc(memory, bytes);
}

int __wrap_posix_memalign(void** memory, std::size_t alignment, std::size_t bytes) {
  return must_fail(Scarce::memory) ? ENOMEM : __real_posix_memalign(memory, alignment, bytes);
}

void* __wrap_mmap(void* address, std::size_t bytes, int protection, int flags, int file, off_t offset) {
  if (!must_fail(Scarce::memory)) return __real_mmap(address, bytes, protection, flags, file, offset);
  errno = ENOMEM;
  return MAP_FAILED;
}

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
