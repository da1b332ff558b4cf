/// @file
/// What the files that serve the calls of <stdio.h> share.
#ifndef SPU_EMU_ISA_LIBC_STDIO_CALL_H
#define SPU_EMU_ISA_LIBC_STDIO_CALL_H

#include <cerrno>
#include <string>

#include "isa/libc/library_calls.h"

namespace spu_emu::isa {

/// The calls by newlib's numbers.
enum class Stdio : unsigned {
  clearerr = 1,
  fclose,
  feof,
  ferror,
  fflush,
  fgetc,
  fgetpos,
  fgets,
  fileno,
  fopen,
  fputc,
  fputs,
  fread,
  freopen,
  fseek,
  fsetpos,
  ftell,
  fwrite,
  getc,
  getchar,
  gets,
  perror,
  putc,
  putchar,
  puts,
  remove,
  rename,
  rewind,
  setbuf,
  setvbuf,
  system,
  tmpfile,
  tmpnam,
  ungetc,
  vfprintf,
  vfscanf,
  vprintf,
  vscanf,
  vsnprintf,
  vsprintf,
  vsscanf
};

/// Numbers of streams.
inline constexpr std::uint32_t kStdin = 1;
inline constexpr std::uint32_t kStdout = 2;

/// A call being served: its arguments, read where they are used.
struct StdioCall {
  StoreBytes& store;
  HostFiles& files;
  std::uint32_t block;

  std::uint32_t word(std::uint32_t index) const { return argument(store, block, index); }
  std::string text(std::uint32_t index) const { return store.text(word(index)); }
};

/// Calls `use` with the stream that argument `index` names.
template <class Use>
CallResult with_stream(const StdioCall& call, std::uint32_t index, Use&& use) {
  std::FILE* stream = call.files.stream(call.word(index));
  return stream == nullptr ? refused(EBADF) : use(stream);
}

inline CallResult put_text(std::FILE* stream, const std::string& text) {
  const bool done = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  return done ? CallResult{static_cast<std::uint32_t>(text.size()), 0} : refused(errno);
}

/// The printf and scanf families.
CallResult call_formatted(const StdioCall& call, Stdio number);

}  // namespace spu_emu::isa

#endif
