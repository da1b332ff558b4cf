/// @file
/// Large tables of which a program uses little.
#ifndef SPU_EMU_ISA_CORE_ZERO_PAGES_H
#define SPU_EMU_ISA_CORE_ZERO_PAGES_H

#include <sys/mman.h>

#include <new>
#include <type_traits>

namespace spu_emu::isa {

/// A T of zeros in pages of its own, which the system gives where they are first touched: to fill the table
/// would take hundreds of page faults for each SPE.
template <class T>
class ZeroPages {
  static_assert(std::is_trivially_default_constructible_v<T> && std::is_trivially_destructible_v<T>);

 public:
  /// Throws std::bad_alloc.
  ZeroPages()
      : memory_(mmap(nullptr, sizeof(T), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) {
    if (memory_ == MAP_FAILED) throw std::bad_alloc();
  }
  ZeroPages(const ZeroPages&) = delete;
  ZeroPages& operator=(const ZeroPages&) = delete;
  ~ZeroPages() { munmap(memory_, sizeof(T)); }

  T& operator*() const { return *static_cast<T*>(memory_); }

 private:
  void* memory_;
};

}  // namespace spu_emu::isa

#endif
