/// @file
/// Frames from a file of any kind.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <variant>

#include "cellsweep/aabb.h"
#include "cellsweep/export.h"
#include "cellsweep/status.h"
#include "cellsweep/world/frame_source.h"
#include "cellsweep/world/recording.h"
#include "cellsweep/world/trace.h"

namespace cellsweep {

class FrameFile;
class RecordedFrames;

/// Opens a file by its ending: .aabbs, .npy or .npz, and looks at all of it once. Of a recording there are
/// never more than two frames in memory at a time; a trace is read into it. Errors: those of read_recording()
/// and read_trace().
CELLSWEEP_API Result<FrameFile> read_frame_file(const std::filesystem::path& path);

/// A recording or a trace. That of a recording's file stays in the file, and is read frame by frame; traces
/// are in memory. Copies and sources share what was read. Any thread may use it.
class CELLSWEEP_API FrameFile {
 public:
  explicit FrameFile(Recording recording);
  explicit FrameFile(Trace trace);

  /// All ids are below this.
  std::size_t ids() const;
  std::size_t frames() const;
  /// The room that all its boxes are in: what a recording says, or what is around those of a trace; of none,
  /// the point at the origin. Looks at all of a trace.
  Aabb world() const;
  /// Shows all boxes of all frames to `look`. Errors: bad_input for a file that cannot be read any more.
  Status for_each_box(const std::function<void(const Aabb&)>& look) const;
  /// Its frames, from the first one on.
  std::unique_ptr<FrameSource> make_source() const;

 private:
  explicit FrameFile(RecordedFrames recorded);
  friend Result<FrameFile> read_frame_file(const std::filesystem::path& path);

  std::variant<std::shared_ptr<const Recording>, std::shared_ptr<const RecordedFrames>,
               std::shared_ptr<const Trace>>
      content_;
};

}  // namespace cellsweep
