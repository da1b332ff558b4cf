/// @file
/// A recording that stays in its file and is read frame by frame.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/status.h"
#include "cellsweep/world/frame_source.h"
#include "cellsweep/world/recording.h"
#include "world/files/box_file.h"
#include "world/files/input_file.h"

namespace cellsweep {

/// What a recording's file says, without its boxes. Any thread may use it.
class RecordedFrames {
 public:
  /// Reads the head, and no box. Errors: bad_input, with the path in front.
  static Result<RecordedFrames> open(const std::filesystem::path& path);

  const std::string& name() const { return head_.name; }
  std::size_t bodies() const { return head_.block.bodies; }
  std::size_t frames() const { return bodies() == 0 ? 0 : head_.block.frames; }
  /// What the file says; without that, the point at the origin until check() has looked.
  Aabb world() const { return head_.world.value_or(Aabb{}); }

  /// Looks at every box once, and notes the world where the file does not say it. Errors: bad_input, with the
  /// path in front, for a box that is not finite with min <= max, or a disk that says no.
  Status check();

  /// All boxes in their order, some at a time. Errors: those of check().
  Status for_each_box(const std::function<void(const Aabb&)>& look) const;

  /// All of it in memory. Errors: those of check().
  Result<Recording> read_all() const;

  /// Boxes from number `first` on. Errors: those of check().
  Status read(std::uint64_t first, std::span<Aabb> boxes) const;

 private:
  std::shared_ptr<const InputFile> file_;
  BoxFile head_;
};

/// The frames, of which there are two in memory at a time.
std::unique_ptr<FrameSource> make_recorded_frames(std::shared_ptr<const RecordedFrames> recorded);

}  // namespace cellsweep
