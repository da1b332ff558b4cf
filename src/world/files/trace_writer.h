/// @file
/// A trace that is written frame by frame.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "cellsweep/engine/new_file.h"
#include "cellsweep/status.h"
#include "world/files/scratch_file.h"
#include "world/files/zip_archive.h"
#include "world/trace_check.h"
#include "world/trace_part.h"

namespace cellsweep {

/// The arrays grow in files without names until their lengths are known; commit() makes an archive of them.
/// Before that, and after an error, there is nothing under the path but what was there. One thread at a time.
class TraceWriter {
 public:
  /// Called once, first. Errors: bad_input for another ending than .npz or a path that cannot be written to;
  /// write_failed.
  Status open(const std::filesystem::path& path);
  /// Errors: bad_input, with path and list in front, for what parse_npz() would refuse; write_failed.
  Status add(const TracePart& part);
  /// After the last frame. The same frames give the same bytes. Errors: those of add().
  Status commit();

  std::size_t ids() const { return check_.ids(); }
  std::size_t frames() const { return check_.frames(); }

 private:
  /// In the order that they have in the archive.
  enum Array : std::size_t {
    kInserted,
    kInsertedBoxes,
    kInsertedEnds,
    kRemoved,
    kRemovedEnds,
    kMoved,
    kMovedBoxes,
    kMovedEnds,
    kCategory,
    kMask,
    kIsStatic,
    kArrays
  };
  struct Column {
    std::shared_ptr<ScratchFile> file;
    std::uint64_t rows = 0;
  };

  Status check(const TracePart& part);
  Status check_boxes(std::string_view name, Array array, std::span<const Aabb> boxes) const;
  Status refuse(const TraceFault& fault) const;
  Status add_bytes(Array array, std::size_t rows);
  template <class Number>
  Status add_numbers(Array array, std::span<const Number> numbers);
  Status add_end(Array ends, Array list);
  Status add_boxes(Array array, std::span<const Aabb> boxes);
  Status add_filters(std::span<const BodyFilter> filters);
  Result<std::vector<ZipMember>> members();

  std::filesystem::path path_;
  NewFile file_;
  std::array<Column, kArrays> columns_;
  TraceCheck check_;
  std::vector<std::byte> bytes_;
};

}  // namespace cellsweep
