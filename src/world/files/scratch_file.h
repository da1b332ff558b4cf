/// @file
/// Room on the disk for what is written before a file's head can be, without a name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cellsweep/engine/new_file.h"
#include "cellsweep/status.h"
#include "world/files/byte_source.h"

namespace cellsweep {

/// Bytes that are in memory while they are few, and then in a file that goes with the program, however it
/// ends. That is where the file will be that it serves, for there is the room that the user means to give; if
/// none can be made there, where the system has such files. One thread at a time.
class ScratchFile final : public ByteSource {
 public:
  /// For a file of this path, which messages name.
  explicit ScratchFile(std::filesystem::path target);
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile() override;

  /// Adds to the end. Errors: write_failed, with the target's path in front, for a disk that says no.
  Status append(std::span<const std::byte> bytes);
  /// Puts into the file what append() still holds; before anybody reads. Errors: those of append().
  Status flush();

  /// Instead of append(): at a place up to the end. Whether it could; status() says why it could not.
  bool write_at(std::uint64_t offset, std::span<const std::byte> bytes) noexcept;
  /// Ok as long as every write was.
  Status status() const;

  std::uint64_t size() const override { return size_; }
  std::int64_t read_at(std::uint64_t offset, std::span<std::byte> bytes) const noexcept override;

 private:
  bool is_in_memory() const { return file_ < 0; }
  void hold(std::uint64_t offset, std::span<const std::byte> bytes) noexcept;
  bool move_to_file() noexcept;
  void write(std::uint64_t offset, std::span<const std::byte> bytes) noexcept;

  std::filesystem::path target_;
  std::string folder_;  // empty: where the system has such files
  int file_ = -1;
  std::uint64_t size_ = 0;
  int error_ = 0;
  std::vector<std::byte> held_;  // all bytes while they are in memory; then those to be added
};

/// Writes all of it. Errors: those of the file, and write_failed where the source cannot be read.
Status copy_to(NewFile& file, const std::filesystem::path& path, const ByteSource& source);

}  // namespace cellsweep
