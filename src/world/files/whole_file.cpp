#include "world/files/whole_file.h"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <system_error>

#include "world/files/file_fault.h"

namespace cellsweep {
namespace {

namespace fs = std::filesystem;

std::string reason_of(int error) {
  return std::generic_category().message(error);
}

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

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

}  // namespace

Status refusal_of_file(const fs::path& path, std::string_view reason) {
  return bad_recording(path.string() + ": " + std::string(reason));
}

Result<std::vector<std::byte>> read_file(const fs::path& path) {
  std::error_code error;
  const bool regular = fs::is_regular_file(path, error);
  if (error) return refusal_of_file(path, "cannot be read: " + error.message());
  if (!regular)
    return refusal_of_file(path, "is not a file that holds a recording, but a folder or a device");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) return refusal_of_file(path, "cannot be read: " + error.message());

  const File file(std::fopen(path.string().c_str(), "rb"));
  if (!file) return refusal_of_file(path, "cannot be read: " + reason_of(errno));
  std::vector<std::byte> bytes(size);
  const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), file.get());
  if (std::ferror(file.get()) != 0) return refusal_of_file(path, "cannot be read: " + reason_of(errno));
  if (count != size || std::fgetc(file.get()) != EOF) {
    return refusal_of_file(path, "changed its size of " + std::to_string(size) + " bytes while it was read");
  }
  return bytes;
}

Status write_file(const fs::path& path, std::span<const std::byte> bytes) {
  TemporaryFile file(path);
  if (file.write(bytes) && file.close() && file.rename_to(path)) return {};
  return refusal_of_file(path, "cannot be written: " + file.reason());
}

}  // namespace cellsweep
