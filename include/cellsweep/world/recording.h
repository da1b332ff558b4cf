/// @file
/// Recorded scenes: boxes per frame, read from and written to files that other tools know.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/export.h"
#include "cellsweep/status.h"
#include "cellsweep/world/frame_source.h"

namespace cellsweep {

/// The boxes of a fixed set of bodies at every stored frame.
struct Recording {
  std::string name;         ///< at most 127 bytes in a file
  std::string type;         ///< at most 127 bytes in a file
  Aabb world;               ///< bounds of the scene; not enforced
  std::size_t bodies = 0;   ///< boxes per frame
  std::vector<Aabb> boxes;  ///< frame-major: box b of frame f is boxes[f * bodies + b]

  /// Stored frames: one more than the updates between them.
  std::size_t frames() const { return bodies == 0 ? 0 : boxes.size() / bodies; }
  std::span<const Aabb> frame(std::size_t index) const {
    return std::span(boxes).subspan(index * bodies, bodies);
  }
};

/// Reads Broadmark's .aabbs from memory: little-endian char[128] name, char[128] type, int32 bodies, int32
/// frames, two int32 zeros, world box; then 1 + frames frames of boxes; a box is 8 floats: min xyz, 0, max
/// xyz, 0. Errors: bad_input naming the byte offset for a file that is too short, too long, whose header
/// lies, or that holds a box which is not finite with min <= max. Allocates no more than the file's own size.
CELLSWEEP_API Result<Recording> parse_aabbs(std::span<const std::byte> file);

/// Reads NumPy's .npy of shape (frames, bodies, 6) — min xyz, max xyz — of float32 or float64 in C order;
/// float64 is rounded to nearest. The world is the bounds of all boxes. Errors: as parse_aabbs().
CELLSWEEP_API Result<Recording> parse_npy(std::span<const std::byte> file);

/// Reads a file by its ending, .aabbs or .npy. Errors: bad_input, with the path in front.
CELLSWEEP_API Result<Recording> read_recording(const std::filesystem::path& path);

/// Writes a file by its ending, .aabbs or .npy (float32), whole or not at all. Errors: bad_input for another
/// ending, a path that cannot be written to, a name too long or no frames; write_failed for a disk that says
/// no.
CELLSWEEP_API Status write_recording(const Recording& recording, const std::filesystem::path& path);

/// Stores what a source gives: frame 0 and up to `updates` more. Errors: bad_input for a source whose bodies
/// come and go or have filters; trace.h has room for these.
CELLSWEEP_API Result<Recording> record(FrameSource& source, std::size_t updates, const Aabb& world);

/// The frames of a recording. `moved()` lists the bodies whose six numbers differ from the frame before.
CELLSWEEP_API std::unique_ptr<FrameSource> make_recording_frames(Recording recording);

}  // namespace cellsweep
