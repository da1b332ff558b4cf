/// @file
/// The files of this machine that an SPU program has open, by the numbers it knows them by.
#ifndef SPU_EMU_ISA_LIBC_HOST_FILES_H
#define SPU_EMU_ISA_LIBC_HOST_FILES_H

#include <cstdint>
#include <cstdio>
#include <map>
#include <set>

#include "spu_emu/emulation.h"

namespace spu_emu::isa {

/// The program reaches the standard streams and what it opened itself, nothing else of this process. Closes
/// with itself what is left open. One thread at a time.
class HostFiles {
 public:
  explicit HostFiles(LibraryCallAccess access) : access_(access) {}
  ~HostFiles();
  HostFiles(const HostFiles&) = delete;
  HostFiles& operator=(const HostFiles&) = delete;

  /// Whether the program may open, name or remove files at all.
  bool allowed() const { return access_ == LibraryCallAccess::files; }

  /// The stream with this number (1, 2, 3 are the standard ones), or null.
  std::FILE* stream(std::uint32_t number) const;
  /// The number of a stream that was opened for the program, 0 for null.
  std::uint32_t add_stream(std::FILE* stream);
  /// Closes what has this number and gives the number to `opened`, unless that is null. The program's
  /// standard streams can be exchanged so, this process's stay what they are. The number, or 0.
  std::uint32_t exchange_stream(std::uint32_t number, std::FILE* opened);
  /// Forgets a stream and closes it, the standard ones excepted; EOF when that fails or there is none.
  int close_stream(std::uint32_t number);

  /// Whether the program may use this descriptor.
  bool owns(int descriptor) const;
  /// Makes a descriptor, if it is one, the program's.
  int add_descriptor(int descriptor);
  int close_descriptor(int descriptor);

 private:
  static bool is_standard(int descriptor) { return descriptor >= 0 && descriptor <= 2; }

  LibraryCallAccess access_;
  std::map<std::uint32_t, std::FILE*> streams_;
  std::set<int> descriptors_;
  std::uint32_t next_stream_ = 4;
};

}  // namespace spu_emu::isa

#endif
