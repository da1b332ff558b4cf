/// @file
/// The library calls of SPU programs (stop codes 0x2100, 0x2101, 0x2104): what newlib's C library asks the
/// host to do.
#ifndef SPU_EMU_ISA_LIBC_LIBRARY_CALLS_H
#define SPU_EMU_ISA_LIBC_LIBRARY_CALLS_H

#include <cstdint>

#include "isa/libc/host_files.h"
#include "isa/libc/store_bytes.h"
#include "spu_emu/emulation.h"

namespace spu_emu::isa {

/// What a call gives back to the program: a value of 32 bits, and its errno when it failed.
struct CallResult {
  std::uint32_t value = 0;
  int error = 0;
};

inline CallResult refused(int error) {
  return {UINT32_MAX, error};
}

/// The calls of one program: its open files end with it. Addresses, descriptors and streams that the program
/// names are checked; a wrong one fails with EFAULT or EBADF, an unknown call with ENOSYS. One thread at a
/// time.
class LibraryCalls {
 public:
  LibraryCalls(StoreBytes store, LibraryCallAccess access) : store_(store), access_(access), files_(access) {}

  /// Serves stop code `code`, whose argument word is at LS address `word_address`. True unless nobody knows
  /// it.
  bool serve(unsigned int code, std::uint32_t word_address);

 private:
  void serve_assisted(bool posix, std::uint32_t word_address);
  void serve_system_call(std::uint32_t block);
  CallResult call(bool posix, unsigned int number, std::uint32_t arguments);

  StoreBytes store_;
  LibraryCallAccess access_;
  HostFiles files_;
};

/// The functions of <stdio.h> by their number in newlib; `arguments` is the LS address of the argument block.
CallResult call_stdio(StoreBytes& store, HostFiles& files, unsigned int number, std::uint32_t arguments);
/// Those of POSIX.
CallResult call_posix(StoreBytes& store, HostFiles& files, unsigned int number, std::uint32_t arguments);

/// Argument `index` of an argument block: each has a quadword, its word is the first.
inline std::uint32_t argument(const StoreBytes& store, std::uint32_t arguments, std::uint32_t index) {
  return store.word(arguments + 16 * index);
}

}  // namespace spu_emu::isa

#endif
