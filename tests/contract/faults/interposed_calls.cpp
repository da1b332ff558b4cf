/// @file
/// The C library's functions for memory and threads, which all of this process call instead of its own, other
/// libraries among them. Not for builds with sanitizers, which do the same.
#include <dlfcn.h>
#include <pthread.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "base/memory/regions.h"
#include "contract/faults/failing_calls.h"

using cellsweep::contract::must_fail;
using cellsweep::contract::Scarce;

extern "C" {

// The GNU C library's other names of its own functions.
void* __libc_malloc(std::size_t bytes);                           // NOLINT: their names
void* __libc_calloc(std::size_t count, std::size_t bytes);        // NOLINT
void* __libc_realloc(void* memory, std::size_t bytes);            // NOLINT
void* __libc_memalign(std::size_t alignment, std::size_t bytes);  // NOLINT

static void* none() {
  errno = ENOMEM;
  return nullptr;
}

void* malloc(std::size_t bytes) {
  return must_fail(Scarce::memory) ? none() : __libc_malloc(bytes);
}

void* calloc(std::size_t count, std::size_t bytes) {
  return must_fail(Scarce::memory) ? none() : __libc_calloc(count, bytes);
}

void* realloc(void* memory, std::size_t bytes) {
  return must_fail(Scarce::memory) ? none() : __libc_realloc(memory, bytes);
}

void* memalign(std::size_t alignment, std::size_t bytes) {
  return must_fail(Scarce::memory) ? none() : __libc_memalign(alignment, bytes);
}

void* aligned_alloc(std::size_t alignment, std::size_t bytes) {
  return memalign(alignment, bytes);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t bytes) {
  void* given = memalign(alignment, bytes);
  if (given == nullptr) return ENOMEM;
  *memory = given;
  return 0;
}

void* mmap(void* address, std::size_t bytes, int protection, int flags, int file, off_t offset) noexcept {
  // Without regions each block is a call of its own, which can fail.
  if (bytes == cellsweep::regions::kAskedAtOnce || must_fail(Scarce::memory)) {
    errno = ENOMEM;
    return MAP_FAILED;
  }
  return reinterpret_cast<void*>(syscall(SYS_mmap, address, bytes, protection, flags, file, offset));
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*begin)(void*),
                   void* argument) noexcept {
  static const auto real = reinterpret_cast<decltype(&pthread_create)>(dlsym(RTLD_NEXT, "pthread_create"));
  if (must_fail(Scarce::threads)) return EAGAIN;
  return real(thread, attributes, begin, argument);
}

}  // extern "C"
