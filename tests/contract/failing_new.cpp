#include "contract/failing_new.h"

#include <cstdlib>
#include <new>

namespace {

thread_local std::uint64_t left = 0;
thread_local bool counts = false;

void* take(std::size_t bytes, std::size_t alignment) {
  if (counts && left > 0 && --left == 0) throw std::bad_alloc();
  const std::size_t whole = (bytes + alignment - 1) / alignment * alignment;
  void* memory = std::aligned_alloc(alignment, whole == 0 ? alignment : whole);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

namespace cellsweep::contract {

void let_new_fail(std::uint64_t n) {
  left = n;
}

void count_new(bool on) {
  counts = on;
}

}  // namespace cellsweep::contract

// The others, for arrays and those that do not throw, call these.
void* operator new(std::size_t bytes) {
  return take(bytes, alignof(std::max_align_t));
}
void* operator new(std::size_t bytes, std::align_val_t alignment) {
  return take(bytes, static_cast<std::size_t>(alignment));
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
