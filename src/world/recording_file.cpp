#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <string_view>
#include <system_error>

#include "cellsweep/world/recording.h"
#include "world/aabbs_file.h"
#include "world/file_fault.h"
#include "world/npy_file.h"

namespace cellsweep {
namespace {

namespace fs = std::filesystem;

/// One kind of file: its ending and its two directions.
struct Format {
  std::string_view ending;
  Result<Recording> (*parse)(std::span<const std::byte>);
  Result<std::vector<std::byte>> (*bytes)(const Recording&);
  bool named;  ///< whether the file holds a name
};

constexpr std::array<Format, 2> kFormats = {{
    {".aabbs", parse_aabbs, aabbs_bytes, true},
    {".npy", parse_npy, npy_bytes, false},
}};

const Format* find_format(const fs::path& path) {
  const std::string ending = path.extension().string();
  for (const Format& format : kFormats) {
    if (format.ending == ending) return &format;
  }
  return nullptr;
}

Status refusal(const fs::path& path, std::string_view reason) {
  return bad_recording(path.string() + ": " + std::string(reason));
}

Status with_path(const fs::path& path, Status status) {
  status.message = path.string() + ": " + status.message;
  return status;
}

Status unknown_ending(const fs::path& path) {
  return refusal(path, "expected a name that ends in .aabbs or .npy");
}

std::string reason_of(int error) {
  return std::generic_category().message(error);
}

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

Result<std::vector<std::byte>> read_file(const fs::path& path) {
  std::error_code error;
  const bool regular = fs::is_regular_file(path, error);
  if (error) return refusal(path, "cannot be read: " + error.message());
  if (!regular) return refusal(path, "is not a file that holds a recording, but a folder or a device");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) return refusal(path, "cannot be read: " + error.message());

  const File file(std::fopen(path.string().c_str(), "rb"));
  if (!file) return refusal(path, "cannot be read: " + reason_of(errno));
  std::vector<std::byte> bytes(size);
  const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), file.get());
  if (std::ferror(file.get()) != 0) return refusal(path, "cannot be read: " + reason_of(errno));
  if (count != size || std::fgetc(file.get()) != EOF) {
    return refusal(path, "changed its size of " + std::to_string(size) + " bytes while it was read");
  }
  return bytes;
}

/// A new file in the folder of another, gone with this object unless it was renamed to that other's name.
class TemporaryFile {
 public:
  explicit TemporaryFile(const fs::path& beside) {
    // Mode x makes two writers, and what a killed one left, take different names.
    for (int i = 0; i < 1000 && !file_; ++i) {
      path_ = fs::path(beside).replace_filename(".cellsweep-" + std::to_string(i) + ".tmp");
      file_.reset(std::fopen(path_.string().c_str(), "wbx"));
      error_ = file_ ? 0 : errno;
      exists_ = file_ != nullptr;
      if (error_ != EEXIST) return;
    }
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    file_.reset();
    std::error_code ignored;
    if (exists_) fs::remove(path_, ignored);
  }

  /// Each step says whether it and all before it worked.
  bool write(std::span<const std::byte> bytes) {
    if (error_ != 0) return false;
    return keep_error(std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) == bytes.size());
  }
  bool close() { return error_ == 0 && keep_error(std::fclose(file_.release()) == 0); }
  bool rename_to(const fs::path& path) {
    if (error_ != 0) return false;
    std::error_code error;
    fs::rename(path_, path, error);
    error_ = error.value();
    exists_ = error_ != 0;
    return !exists_;
  }

  std::string reason() const { return reason_of(error_); }

 private:
  bool keep_error(bool worked) {
    if (!worked) error_ = errno != 0 ? errno : EIO;
    return worked;
  }

  fs::path path_;
  File file_;
  bool exists_ = false;
  int error_ = 0;
};

Status write_file(const fs::path& path, std::span<const std::byte> bytes) {
  TemporaryFile file(path);
  if (file.write(bytes) && file.close() && file.rename_to(path)) return {};
  return refusal(path, "cannot be written: " + file.reason());
}

}  // namespace

Result<Recording> read_recording(const std::filesystem::path& path) {
  const Format* format = find_format(path);
  if (format == nullptr) return unknown_ending(path);
  const Result<std::vector<std::byte>> bytes = read_file(path);
  if (!bytes) return bytes.status();
  Result<Recording> recording = format->parse(*bytes);
  if (!recording) return with_path(path, recording.status());
  if (!format->named) recording->name = path.stem().string();
  return recording;
}

Status write_recording(const Recording& recording, const std::filesystem::path& path) {
  const Format* format = find_format(path);
  if (format == nullptr) return unknown_ending(path);
  const Result<std::vector<std::byte>> bytes = format->bytes(recording);
  if (!bytes) return with_path(path, bytes.status());
  return write_file(path, *bytes);
}

}  // namespace cellsweep
