/// @file
/// A trace that stays in its file and is read frame by frame.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "cellsweep/aabb.h"
#include "cellsweep/status.h"
#include "cellsweep/world/frame_source.h"
#include "world/files/input_file.h"
#include "world/trace_frames.h"

namespace cellsweep {

class TraceReader;

/// What a trace's file says, without its frames. Any thread may use it. Errors of all: bad_input, with the
/// path in front.
class RecordedTrace {
 public:
  /// Looks at every frame once.
  static Result<RecordedTrace> open(const std::filesystem::path& path);

  std::size_t ids() const { return summary_.ids; }
  std::size_t frames() const { return frames_; }
  /// What is around all boxes; around none, the point at the origin.
  Aabb world() const { return world_; }
  const TraceSummary& summary() const { return summary_; }
  const std::string& path() const { return file_->path(); }

  /// All boxes, frame by frame.
  Status for_each_box(const std::function<void(const Aabb&)>& look) const;
  /// All parts, frame by frame.
  Status for_each_part(const std::function<void(const TracePart&)>& look) const;

  /// To read it once more from the first frame on, by one thread; its errors have no path in front.
  Result<std::unique_ptr<TraceReader>> open_reader() const;

 private:
  std::shared_ptr<const InputFile> file_;
  TraceSummary summary_;
  std::size_t frames_ = 0;
  Aabb world_;
};

/// The frames, of which there are two in memory at a time.
std::unique_ptr<FrameSource> make_trace_frames(std::shared_ptr<const RecordedTrace> recorded);

}  // namespace cellsweep
