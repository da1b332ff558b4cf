/// @file
/// A file that is read in parts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include "cellsweep/status.h"
#include "world/files/byte_source.h"

namespace cellsweep {

/// A file of a size that is known. Any thread may read.
class InputFile final : public ByteSource {
 public:
  /// Errors: bad_input, with the path in front, for what cannot be read or is no file.
  static Result<std::shared_ptr<const InputFile>> open(const std::filesystem::path& path);

  explicit InputFile(std::string path) : path_(std::move(path)) {}
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;
  ~InputFile() override;

  const std::string& path() const { return path_; }
  std::uint64_t size() const override { return size_; }
  std::int64_t read_at(std::uint64_t offset, std::span<std::byte> bytes) const noexcept override;

  /// Fills `bytes` with those from `offset` on, which are within the size. Errors: bad_input, with the path
  /// in front, for a disk that says no, or a file that has become shorter.
  Status read(std::uint64_t offset, std::span<std::byte> bytes) const;

 private:
  std::string path_;
  int file_ = -1;
  std::uint64_t size_ = 0;
};

}  // namespace cellsweep
