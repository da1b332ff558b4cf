/// @file
/// C++'s operators for the whole program, C++'s own library included: strings and streams ask there.
/// Libraries in C do not.
#include <cstddef>
#include <cstdlib>
#include <new>

#include "contract/faults/failing_calls.h"

using cellsweep::contract::must_fail;
using cellsweep::contract::Scarce;

namespace {

void* take(std::size_t bytes, std::size_t alignment) {
  if (must_fail(Scarce::memory)) return nullptr;
  return std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
}

}  // namespace

void* operator new(std::size_t bytes, std::align_val_t alignment) {
  if (void* const memory = take(bytes, static_cast<std::size_t>(alignment))) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return take(bytes, __STDCPP_DEFAULT_NEW_ALIGNMENT__);
}
void* operator new(std::size_t bytes) {
  return operator new (bytes, std::align_val_t{__STDCPP_DEFAULT_NEW_ALIGNMENT__});
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
