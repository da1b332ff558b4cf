/// @file
/// What the linker gives this project's own objects in place of the C library's functions for memory
/// (--wrap): in builds with sanitizers, which have the C library's names for themselves, and where other
/// libraries end the process if they get none.
#include <pthread.h>
#include <sys/mman.h>

#include <cerrno>
#include <cstdlib>

#include "base/memory/regions.h"
#include "contract/faults/failing_calls.h"

using cellsweep::contract::must_fail;
using cellsweep::contract::Scarce;

extern "C" {

// NOLINTBEGIN: the linker's names
void* __real_malloc(std::size_t bytes);
void* __real_realloc(void* memory, std::size_t bytes);
int __real_posix_memalign(void** memory, std::size_t alignment, std::size_t bytes);
void* __real_mmap(void* address, std::size_t bytes, int protection, int flags, int file, off_t offset);

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
  // Without regions each block is a call of its own, which can fail.
  if (bytes != cellsweep::regions::kAskedAtOnce && !must_fail(Scarce::memory))
    return __real_mmap(address, bytes, protection, flags, file, offset);
  errno = ENOMEM;
  return MAP_FAILED;
}
// NOLINTEND

}  // extern "C"
