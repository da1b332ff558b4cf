/// @file
/// What the head of a file of boxes says, and how the boxes behind it are read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "cellsweep/aabb.h"
#include "cellsweep/status.h"
#include "cellsweep/world/recording.h"
#include "world/files/file_fault.h"

namespace cellsweep {

/// A head that fits its file's size.
struct BoxFile {
  /// No head of a file is longer.
  static constexpr std::size_t kMostHeadBytes = std::size_t{1} << 20;

  std::string name;
  std::string type;
  std::optional<Aabb> world;  ///< nothing: what is around all boxes
  BoxBlock block;
  /// Reads boxes from as many whole ones' bytes, the first of which is box number `first` of the block.
  /// Errors: bad_input for one that is not finite with min <= max.
  std::function<Status(std::span<const std::byte> bytes, std::uint64_t first, std::span<Aabb> boxes)> load;

  std::uint64_t boxes() const { return block.frames * block.bodies; }
};

/// The whole recording, of which `read` reads all boxes. Errors: those of `read`.
Result<Recording> recording_of(const BoxFile& head, const std::function<Status(std::span<Aabb>)>& read);

/// That of which these are all bytes. Errors: those of BoxFile::load.
Result<Recording> load_all(const BoxFile& head, std::span<const std::byte> file);

/// The heads of Broadmark's .aabbs and NumPy's .npy. `begin` is the first kMostHeadBytes of a file of so many
/// bytes, or all. Errors: those of parse_aabbs() and parse_npy() that are not of a box.
Result<BoxFile> parse_aabbs_head(std::span<const std::byte> begin, std::uint64_t file_bytes);
Result<BoxFile> parse_npy_head(std::span<const std::byte> begin, std::uint64_t file_bytes);

}  // namespace cellsweep
