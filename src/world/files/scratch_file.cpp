#include "world/files/scratch_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <system_error>
#include <utility>

#include "base/text.h"
#include "world/files/read_part.h"

namespace cellsweep {
namespace {

constexpr std::size_t kHeldBytes = std::size_t{1} << 16;
constexpr mode_t kOwnersMode = 0600;

Status cannot_be_written(const std::string& path, int error) {
  Status status =
      Status::bad_input(text(path, ": cannot be written: ", std::generic_category().message(error), "."));
  status.code = StatusCode::write_failed;
  return status;
}

// For file systems that know no nameless files. The name is one of those that NewFile clears away where it
// finds nobody's lock on them, should the program be killed before it is taken off.
int open_named(const char* folder) noexcept {
  constexpr int kMostNames = 1000;
  std::array<char, PATH_MAX> name{};
  for (int number = 0; number < kMostNames; ++number) {
    std::snprintf(name.data(), name.size(), "%s/.cellsweep-%d.tmp", folder, number);
    const int file = ::open(name.data(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, kOwnersMode);
    if (file < 0 && errno == EEXIST) continue;
    if (file >= 0) {
      ::flock(file, LOCK_EX | LOCK_NB);
      ::unlink(name.data());
    }
    return file;
  }
  return -1;
}

int open_nameless(const char* folder) noexcept {
#ifdef O_TMPFILE
  const int file = ::open(folder, O_TMPFILE | O_RDWR | O_CLOEXEC, kOwnersMode);
  if (file >= 0 || (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL)) return file;
#endif
  return open_named(folder);
}

// Where a device is written to, there is no room for files.
std::string folder_of(const std::filesystem::path& target) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(target, error);
  const std::filesystem::path& path = error ? target : real;
  if (std::filesystem::exists(path, error) && !std::filesystem::is_regular_file(path, error)) return "";
  return path.has_parent_path() ? path.parent_path().string() : ".";
}

}  // namespace

ScratchFile::ScratchFile(std::filesystem::path target)
    : target_(std::move(target)), folder_(folder_of(target_)) {
  if (folder_.empty()) {
    std::error_code none;
    const std::filesystem::path other = std::filesystem::temp_directory_path(none);
    folder_ = none ? "/tmp" : other.string();
  }
  held_.reserve(kHeldBytes);
}

ScratchFile::~ScratchFile() {
  if (file_ >= 0) ::close(file_);
}

Status ScratchFile::append(std::span<const std::byte> bytes) {
  if (held_.size() + bytes.size() > kHeldBytes) {
    if (Status status = flush(); !status.ok()) return status;
    if (is_in_memory() && !move_to_file()) return status();
  }
  if (bytes.size() > kHeldBytes) {
    write(size_, bytes);
  } else {
    hold(held_.size(), bytes);
    if (is_in_memory()) size_ = held_.size();
  }
  return status();
}

Status ScratchFile::flush() {
  if (is_in_memory()) return status();
  write(size_, held_);
  held_.clear();
  return status();
}

bool ScratchFile::write_at(std::uint64_t offset, std::span<const std::byte> bytes) noexcept {
  if (error_ != 0) return false;
  if (is_in_memory() && offset + bytes.size() > kHeldBytes && !move_to_file()) return false;
  if (is_in_memory()) {
    hold(offset, bytes);
    size_ = held_.size();
  } else {
    write(offset, bytes);
  }
  return error_ == 0;
}

// There is room for all that is held.
void ScratchFile::hold(std::uint64_t offset, std::span<const std::byte> bytes) noexcept {
  held_.resize(std::max<std::size_t>(held_.size(), offset + bytes.size()));
  std::ranges::copy(bytes, held_.begin() + static_cast<std::ptrdiff_t>(offset));
}

bool ScratchFile::move_to_file() noexcept {
  if (error_ != 0) return false;
  file_ = open_nameless(folder_.c_str());
  if (file_ < 0) error_ = errno;
  write(0, held_);
  held_.clear();
  return error_ == 0;
}

void ScratchFile::write(std::uint64_t offset, std::span<const std::byte> bytes) noexcept {
  while (!bytes.empty() && error_ == 0) {
    const ssize_t written = ::pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      error_ = written < 0 ? errno : EIO;
      break;
    }
    offset += static_cast<std::uint64_t>(written);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    size_ = std::max(size_, offset);
  }
}

Status ScratchFile::status() const {
  return error_ == 0 ? Status() : cannot_be_written(target_.string(), error_);
}

std::int64_t ScratchFile::read_at(std::uint64_t offset, std::span<std::byte> bytes) const noexcept {
  return is_in_memory() ? BytesInMemory(held_).read_at(offset, bytes) : read_part(file_, offset, bytes);
}

Status copy_to(NewFile& file, const std::filesystem::path& path, const ByteSource& source) {
  std::vector<std::byte> part(std::min<std::uint64_t>(std::uint64_t{1} << 20, source.size()));
  for (std::uint64_t offset = 0; offset < source.size();) {
    const std::int64_t count = source.read_at(offset, part);
    if (count <= 0) return cannot_be_written(path.string(), count < 0 ? static_cast<int>(-count) : EIO);
    const std::string_view bytes(reinterpret_cast<const char*>(part.data()), static_cast<std::size_t>(count));
    if (Status status = file.write(bytes); !status.ok()) return status;
    offset += bytes.size();
  }
  return {};
}

}  // namespace cellsweep
