// The printf and scanf families of SPU programs, to streams and into the local store.
#include <cstdio>

#include "isa/libc/print_format.h"
#include "isa/libc/scan_format.h"
#include "isa/libc/stdio_call.h"

namespace spu_emu::isa {

namespace {
PrintResult printed(const StdioCall& call, std::uint32_t format_index) {
  ArgumentList arguments(call.store, call.block + 16 * (format_index + 1));
  return print_format(call.store, call.text(format_index), arguments);
}

CallResult print_to(const StdioCall& call, std::FILE* stream, std::uint32_t format_index) {
  const PrintResult result = printed(call, format_index);
  return result.error == 0 ? put_text(stream, result.text) : refused(result.error);
}

CallResult print_into_store(const StdioCall& call, std::uint32_t format_index, std::uint32_t capacity) {
  const PrintResult result = printed(call, format_index);
  if (result.error != 0) return refused(result.error);
  if (capacity != 0) {
    const std::string kept = result.text.substr(0, capacity - 1);
    call.store.write(call.word(0), std::as_bytes(std::span(kept.c_str(), kept.size() + 1)));
  }
  return {static_cast<std::uint32_t>(result.text.size()), 0};
}

CallResult scan(const StdioCall& call, ScanSource& source, std::uint32_t format_index) {
  ArgumentList arguments(call.store, call.block + 16 * (format_index + 1));
  return {static_cast<std::uint32_t>(scan_format(call.store, source, call.text(format_index), arguments)), 0};
}

CallResult scan_stream(const StdioCall& call, std::FILE* stream, std::uint32_t format_index) {
  StreamSource source(stream);
  return scan(call, source, format_index);
}

CallResult scan_text(const StdioCall& call) {
  const std::string text = call.text(0);
  TextSource source(text);
  return scan(call, source, 1);
}

}  // namespace

CallResult call_formatted(const StdioCall& call, Stdio number) {
  switch (number) {
    case Stdio::vprintf:
      return print_to(call, call.files.stream(kStdout), 0);
    case Stdio::vfprintf:
      return with_stream(call, 0, [&](std::FILE* stream) { return print_to(call, stream, 1); });
    case Stdio::vsnprintf:
      return print_into_store(call, 2, call.word(1));
    case Stdio::vsprintf:
      return print_into_store(call, 1, UINT32_MAX);
    case Stdio::vscanf:
      return scan_stream(call, call.files.stream(kStdin), 0);
    case Stdio::vfscanf:
      return with_stream(call, 0, [&](std::FILE* stream) { return scan_stream(call, stream, 1); });
    default:
      return scan_text(call);
  }
}

}  // namespace spu_emu::isa
