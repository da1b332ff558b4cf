#include "world/files/whole_file.h"

#include <cerrno>
#include <cstdio>
#include <memory>
#include <new>
#include <string>
#include <system_error>

#include "base/new_file.h"
#include "world/files/file_fault.h"

namespace cellsweep {
namespace {

namespace fs = std::filesystem;

std::string reason_of(int error) {
  if (error == ENOMEM) throw std::bad_alloc();
  return std::generic_category().message(error);
}

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

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
  return write_new_file(path.string(), {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

}  // namespace cellsweep
