#include "world/files/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <new>
#include <system_error>

#include "world/files/read_part.h"
#include "world/files/whole_file.h"

namespace cellsweep {
namespace {

Status cannot_read(const std::string& path, int error) {
  if (error == ENOMEM) throw std::bad_alloc();
  return refusal_of_file(path, "cannot be read: " + std::generic_category().message(error));
}

}  // namespace

InputFile::~InputFile() {
  if (file_ >= 0) ::close(file_);
}

// A pipe is not waited for: it is no file.
Result<std::shared_ptr<const InputFile>> InputFile::open(const std::filesystem::path& path) {
  auto file = std::make_shared<InputFile>(path.string());
  file->file_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
  struct stat status {};
  if (file->file_ < 0 || ::fstat(file->file_, &status) != 0) return cannot_read(file->path_, errno);
  if (!S_ISREG(status.st_mode))
    return refusal_of_file(path, "is not a file that holds a recording, but a folder or a device");
  file->size_ = static_cast<std::uint64_t>(status.st_size);
  return std::shared_ptr<const InputFile>(std::move(file));
}

std::int64_t InputFile::read_at(std::uint64_t offset, std::span<std::byte> bytes) const noexcept {
  return read_part(file_, offset, bytes);
}

Status InputFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
  const std::int64_t count = read_at(offset, bytes);
  if (count < 0) return cannot_read(path_, static_cast<int>(-count));
  if (static_cast<std::uint64_t>(count) < bytes.size())
    return refusal_of_file(path_, "lost bytes of its " + std::to_string(size_) + " while it was read");
  return {};
}

}  // namespace cellsweep
