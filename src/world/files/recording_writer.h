/// @file
/// A recording that is written frame by frame.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/engine/new_file.h"
#include "cellsweep/status.h"
#include "world/files/recording_head.h"
#include "world/files/scratch_file.h"

namespace cellsweep {

/// The boxes are in a file without a name until they are counted; commit() puts the head before them. Until
/// then, and after an error, there is nothing under the path but what was there. One thread at a time.
class RecordingWriter {
 public:
  /// Called once, first; the writer counts the frames itself. Errors: those of write_recording().
  Status open(const std::filesystem::path& path, RecordingHead head);
  /// The boxes of all bodies. Errors of these: those of write_recording().
  Status add(std::span<const Aabb> boxes);
  Status commit();

  std::size_t frames() const { return head_.frames; }

 private:
  std::filesystem::path path_;
  RecordingHead head_;
  NewFile file_;
  std::shared_ptr<ScratchFile> boxes_;
  std::vector<std::byte> bytes_;
};

}  // namespace cellsweep
