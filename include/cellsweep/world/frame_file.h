/// @file
/// Frames from a file of any kind.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <variant>

#include "cellsweep/aabb.h"
#include "cellsweep/export.h"
#include "cellsweep/status.h"
#include "cellsweep/world/frame_source.h"
#include "cellsweep/world/recording.h"
#include "cellsweep/world/trace.h"

namespace cellsweep {

/// A recording or a trace. Copies and sources share what was read. Any thread may use it.
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
  /// All boxes of all frames, in two lists; valid as long as this.
  std::array<std::span<const Aabb>, 2> boxes() const;
  /// Null for a trace.
  const Recording* recording() const;
  const Trace* trace() const;
  /// Its frames, from the first one on.
  std::unique_ptr<FrameSource> make_source() const;

 private:
  std::variant<std::shared_ptr<const Recording>, std::shared_ptr<const Trace>> content_;
};

/// Reads a file by its ending: .aabbs, .npy or .npz. Errors: those of read_recording() and read_trace().
CELLSWEEP_API Result<FrameFile> read_frame_file(const std::filesystem::path& path);

}  // namespace cellsweep
