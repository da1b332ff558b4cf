#include "isa/libc/host_files.h"

#include <unistd.h>

#include <cerrno>

namespace spu_emu::isa {

HostFiles::~HostFiles() {
  for (const auto& [number, stream] : streams_) std::fclose(stream);
  for (const int descriptor : descriptors_) close(descriptor);
}

std::FILE* HostFiles::stream(std::uint32_t number) const {
  const auto found = streams_.find(number);
  if (found != streams_.end()) return found->second;
  switch (number) {
    case 1:
      return stdin;
    case 2:
      return stdout;
    case 3:
      return stderr;
    default:
      return nullptr;
  }
}

std::uint32_t HostFiles::add_stream(std::FILE* stream) {
  if (stream == nullptr) return 0;
  streams_[next_stream_] = stream;
  return next_stream_++;
}

std::uint32_t HostFiles::exchange_stream(std::uint32_t number, std::FILE* opened) {
  close_stream(number);
  if (opened == nullptr) return 0;
  streams_[number] = opened;
  return number;
}

int HostFiles::close_stream(std::uint32_t number) {
  std::FILE* closed = stream(number);
  if (closed == nullptr) {
    errno = EBADF;
    return EOF;
  }
  if (streams_.erase(number) == 0) return std::fflush(closed);
  return std::fclose(closed);
}

bool HostFiles::owns(int descriptor) const {
  if (is_standard(descriptor) || descriptors_.count(descriptor) != 0) return true;
  for (const auto& [number, stream] : streams_) {
    if (fileno(stream) == descriptor) return true;
  }
  return false;
}

int HostFiles::add_descriptor(int descriptor) {
  if (descriptor >= 0) descriptors_.insert(descriptor);
  return descriptor;
}

int HostFiles::close_descriptor(int descriptor) {
  if (is_standard(descriptor)) return 0;
  if (descriptors_.erase(descriptor) != 0) return close(descriptor);
  errno = EBADF;
  return -1;
}

}  // namespace spu_emu::isa
