/// @file
/// Recorded worlds whose bodies come, go and have filters: what a physics engine told its broadphase, frame
/// by frame.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/export.h"
#include "cellsweep/filter.h"
#include "cellsweep/pair.h"
#include "cellsweep/status.h"
#include "cellsweep/world/frame_source.h"

namespace cellsweep {

/// What changed in each frame. Frame f has the elements from `..._ends[f - 1]` (0 for frame 0) to
/// `..._ends[f]` of each list, bodies in ascending order. A body that nobody mentions stays where it is.
struct Trace {
  std::string name;  ///< not in the file: the file's own name
  std::vector<BodyId> inserted;
  std::vector<Aabb> inserted_boxes;
  std::vector<BodyFilter> inserted_filters;  ///< as many, or none: the default for all
  std::vector<BodyId> removed;
  std::vector<BodyId> moved;
  std::vector<Aabb> moved_boxes;
  std::vector<std::size_t> inserted_ends;  ///< one for each frame, at least one
  std::vector<std::size_t> removed_ends;
  std::vector<std::size_t> moved_ends;

  std::size_t frames() const { return inserted_ends.size(); }
  /// One more than the largest id.
  std::size_t ids() const;
};

/// False in a build without libzip: it reads and writes no .npz, and says so in words.
CELLSWEEP_API bool traces_have_files();

/// Reads NumPy's .npz with these arrays: inserted, removed, moved (N) of any integers; inserted_boxes,
/// moved_boxes (N, 6) of float32 or float64; inserted_ends, removed_ends, moved_ends (frames) of any
/// integers; and, all or none, category, mask, is_static (inserted). Errors: bad_input naming the array and
/// the byte offset in it for what does not hold together: a body that is moved or removed and is not there,
/// one that is inserted twice, or in the frame in which it is removed, lists that do not ascend or do not end
/// where they say, ids of 16 times the number of inserted bodies and of a million or more, a box which is not
/// finite with min <= max, and any other array. Allocates no more than the arrays say, which the file's size
/// bounds.
CELLSWEEP_API Result<Trace> parse_npz(std::span<const std::byte> file);

/// Reads a .npz file. Errors: bad_input, with the path in front.
CELLSWEEP_API Result<Trace> read_trace(const std::filesystem::path& path);

/// Writes a .npz file, whole or not at all; the same trace gives the same bytes. Errors: bad_input for
/// another ending, a path that cannot be written to or a trace that parse_npz() would refuse; write_failed
/// for a disk that says no.
CELLSWEEP_API Status write_trace(const Trace& trace, const std::filesystem::path& path);

/// Stores what a source tells: frame 0 and up to `updates` more.
CELLSWEEP_API Trace record_trace(FrameSource& source, std::size_t updates);

/// The frames of a trace that parse_npz() would take.
CELLSWEEP_API std::unique_ptr<FrameSource> make_trace_frames(std::shared_ptr<const Trace> trace);

}  // namespace cellsweep
