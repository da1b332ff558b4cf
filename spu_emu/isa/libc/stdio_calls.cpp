// The functions of <stdio.h> that newlib leaves to the host.
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <vector>

#include "isa/libc/stdio_call.h"

namespace spu_emu::isa {

namespace {
/// A C function's result, with errno when it is the one that means failure.
CallResult checked(int value, int failure) {
  return {static_cast<std::uint32_t>(value), value == failure ? errno : 0};
}

CallResult get_character(std::FILE* stream) {
  return {static_cast<std::uint32_t>(std::fgetc(stream)), 0};
}

/// Reads a line into `longest` bytes at `ls`, NUL included; null at the end of the file.
CallResult get_line(const StdioCall& call, std::FILE* stream, std::uint32_t ls, std::uint32_t longest,
                    bool keep_end) {
  longest = std::min(longest, call.store.size());
  std::string line;
  int c = 0;
  while (line.size() + 1 < longest && (c = std::fgetc(stream)) != EOF) {
    if (c != '\n' || keep_end) line += static_cast<char>(c);
    if (c == '\n') break;
  }
  if (longest == 0 || (line.empty() && c == EOF)) return {0, 0};
  call.store.write(ls, std::as_bytes(std::span(line.c_str(), line.size() + 1)));
  return {ls, 0};
}

/// fread and fwrite: buffer, size, count, stream. The buffer must lie in the local store as a whole.
CallResult move_items(const StdioCall& call, bool to_store) {
  const std::uint32_t ls = call.word(0);
  const std::uint64_t bytes = std::uint64_t{call.word(1)} * call.word(2);
  if (bytes == 0) return {0, 0};
  if (bytes > call.store.size()) throw BadAddress{};
  const auto size = static_cast<std::uint32_t>(bytes);
  const auto there = call.store.read(ls, size);
  return with_stream(call, 3, [&](std::FILE* stream) -> CallResult {
    errno = 0;
    std::size_t moved = 0;
    if (to_store) {
      std::vector<std::byte> buffer(size);
      moved = std::fread(buffer.data(), 1, size, stream);
      call.store.write(ls, std::span(buffer).first(moved));
    } else {
      moved = std::fwrite(there.data(), 1, size, stream);
    }
    return {static_cast<std::uint32_t>(moved / call.word(1)), moved == size ? 0 : errno};
  });
}

CallResult open_stream(const StdioCall& call, std::FILE* opened) {
  return {call.files.add_stream(opened), opened == nullptr ? errno : 0};
}

/// The calls that name files of the host.
CallResult call_naming_files(const StdioCall& call, Stdio number) {
  if (!call.files.allowed())
    return {number == Stdio::remove || number == Stdio::rename ? UINT32_MAX : 0U, EACCES};
  switch (number) {
    case Stdio::fopen:
      return open_stream(call, std::fopen(call.text(0).c_str(), call.text(1).c_str()));
    case Stdio::freopen: {
      if (call.files.stream(call.word(2)) == nullptr) return {0, EBADF};
      std::FILE* opened = std::fopen(call.text(0).c_str(), call.text(1).c_str());
      const int error = opened == nullptr ? errno : 0;
      return {call.files.exchange_stream(call.word(2), opened), error};
    }
    case Stdio::tmpfile:
      return open_stream(call, std::tmpfile());
    case Stdio::remove:
      return checked(std::remove(call.text(0).c_str()), -1);
    default:
      return checked(std::rename(call.text(0).c_str(), call.text(1).c_str()), -1);
  }
}

/// fseek, ftell, rewind, and positions, of which the program keeps 16 bytes.
CallResult call_position(const StdioCall& call, Stdio number, std::FILE* stream) {
  switch (number) {
    case Stdio::fseek:
      return checked(
          std::fseek(stream, static_cast<std::int32_t>(call.word(1)), static_cast<int>(call.word(2))), -1);
    case Stdio::ftell:
      return checked(static_cast<int>(std::ftell(stream)), -1);
    case Stdio::fgetpos: {
      const long position = std::ftell(stream);
      call.store.set_doubleword(call.word(1), static_cast<std::uint64_t>(position));
      return checked(position < 0 ? -1 : 0, -1);
    }
    case Stdio::fsetpos:
      return checked(std::fseek(stream, static_cast<long>(call.store.doubleword(call.word(1))), SEEK_SET),
                     -1);
    default:
      std::rewind(stream);
      return {};
  }
}

/// The calls whose only argument is a stream.
CallResult call_on_stream(const StdioCall& call, Stdio number, std::FILE* stream) {
  switch (number) {
    case Stdio::clearerr:
      std::clearerr(stream);
      return {};
    case Stdio::feof:
      return {static_cast<std::uint32_t>(std::feof(stream)), 0};
    case Stdio::ferror:
      return {static_cast<std::uint32_t>(std::ferror(stream)), 0};
    case Stdio::fflush:
      return checked(std::fflush(stream), EOF);
    case Stdio::fileno:
      return checked(fileno(stream), -1);
    case Stdio::fgetc:
    case Stdio::getc:
      return get_character(stream);
    default:
      return call_position(call, number, stream);
  }
}

CallResult call_characters(const StdioCall& call, Stdio number) {
  std::FILE* out = call.files.stream(kStdout);
  switch (number) {
    case Stdio::putchar:
      return {static_cast<std::uint32_t>(std::fputc(static_cast<int>(call.word(0)), out)), 0};
    case Stdio::puts:
      return put_text(out, call.text(0) + '\n');
    case Stdio::fputs:
      return with_stream(call, 1, [&](std::FILE* stream) { return put_text(stream, call.text(0)); });
    case Stdio::ungetc:
      return with_stream(call, 1, [&](std::FILE* stream) {
        return CallResult{static_cast<std::uint32_t>(std::ungetc(static_cast<int>(call.word(0)), stream)), 0};
      });
    case Stdio::getchar:
      return get_character(call.files.stream(kStdin));
    case Stdio::gets:
      return get_line(call, call.files.stream(kStdin), call.word(0), call.store.size(), false);
    case Stdio::fgets:
      return with_stream(call, 2, [&](std::FILE* stream) {
        return get_line(call, stream, call.word(0), call.word(1), true);
      });
    default:  // fputc and putc
      return with_stream(call, 1, [&](std::FILE* stream) {
        return CallResult{static_cast<std::uint32_t>(std::fputc(static_cast<int>(call.word(0)), stream)), 0};
      });
  }
}

CallResult print_error(const StdioCall& call) {
  const std::uint32_t text = call.word(0);
  const std::string prefix = text == 0 ? "" : call.store.text(text);
  std::fprintf(stderr, "%s%s%s\n", prefix.c_str(), prefix.empty() ? "" : ": ",
               std::strerror(static_cast<int>(call.word(1))));
  return {};
}
}  // namespace

CallResult call_stdio(StoreBytes& store, HostFiles& files, unsigned int code, std::uint32_t arguments) {
  const StdioCall call{store, files, arguments};
  const auto number = static_cast<Stdio>(code);
  switch (number) {
    case Stdio::clearerr:
    case Stdio::feof:
    case Stdio::ferror:
    case Stdio::fflush:
    case Stdio::fileno:
    case Stdio::fgetc:
    case Stdio::getc:
    case Stdio::fseek:
    case Stdio::ftell:
    case Stdio::fgetpos:
    case Stdio::fsetpos:
    case Stdio::rewind:
      return with_stream(call, 0, [&](std::FILE* stream) { return call_on_stream(call, number, stream); });
    case Stdio::fclose:
      return checked(files.close_stream(call.word(0)), EOF);
    case Stdio::fopen:
    case Stdio::freopen:
    case Stdio::tmpfile:
    case Stdio::remove:
    case Stdio::rename:
      return call_naming_files(call, number);
    case Stdio::fread:
      return move_items(call, true);
    case Stdio::fwrite:
      return move_items(call, false);
    case Stdio::fputc:
    case Stdio::putc:
    case Stdio::putchar:
    case Stdio::puts:
    case Stdio::fputs:
    case Stdio::ungetc:
    case Stdio::getchar:
    case Stdio::gets:
    case Stdio::fgets:
      return call_characters(call, number);
    case Stdio::perror:
      return print_error(call);
    case Stdio::setbuf:
    case Stdio::setvbuf:
      return {};  // The host's buffers do what they do.
    case Stdio::vprintf:
    case Stdio::vfprintf:
    case Stdio::vsnprintf:
    case Stdio::vsprintf:
    case Stdio::vscanf:
    case Stdio::vfscanf:
    case Stdio::vsscanf:
      return call_formatted(call, number);
    default:
      return refused(ENOSYS);
  }
}

}  // namespace spu_emu::isa
