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
class RecordedTrace;

/// Opens a file by its ending: .aabbs, .npy or .npz, and looks at all of it once. It stays in its file: there
/// are never more than two frames in memory at a time, and of a trace the boxes of all ids. Errors: those of
/// read_recording() and read_trace().
CELLSWEEP_API Result<FrameFile> read_frame_file(const std::filesystem::path& path);

/// How much went into a file.
struct FramesWritten {
  std::size_t ids = 0;  ///< all are below this
  std::size_t frames = 0;
};

/// Writes what a source tells, from where it stands up to `updates` more frames, by the ending: .aabbs, .npy
/// or .npz; whole or not at all. There is one frame in memory at a time; what is longer waits beside the
/// file, without a name. `world` is what a recording says of its world. Errors: those of the source, of
/// record(), of write_recording() and of write_trace().
CELLSWEEP_API Result<FramesWritten> write_frame_file(FrameSource& source, std::size_t updates,
                                                     const Aabb& world, const std::filesystem::path& path);

/// A recording or a trace, in its file or in memory. Copies and sources share what was read. Any thread may
/// use it.
class CELLSWEEP_API FrameFile {
 public:
  explicit FrameFile(Recording recording);
  explicit FrameFile(Trace trace);

  /// All ids are below this.
  std::size_t ids() const;
  std::size_t frames() const;
  /// The room that all its boxes are in: what a recording says, or what is around those of a trace; of none,
  /// the point at the origin. Looks at all of a trace in memory.
  Aabb world() const;
  /// Shows all boxes of all frames to `look`. Errors: bad_input for a file that cannot be read any more.
  Status for_each_box(const std::function<void(const Aabb&)>& look) const;
  /// Its frames, from the first one on.
  std::unique_ptr<FrameSource> make_source() const;

 private:
  explicit FrameFile(RecordedFrames recorded);
  explicit FrameFile(RecordedTrace recorded);
  friend Result<FrameFile> read_frame_file(const std::filesystem::path& path);

  std::variant<std::shared_ptr<const Recording>, std::shared_ptr<const RecordedFrames>,
               std::shared_ptr<const Trace>, std::shared_ptr<const RecordedTrace>>
      content_;
};

}  // namespace cellsweep
