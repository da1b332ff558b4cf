/// @file
/// Writing Broadmark's .aabbs; reading it is parse_aabbs() of the public face.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cellsweep/status.h"
#include "cellsweep/world/recording.h"
#include "world/files/recording_head.h"

namespace cellsweep {

/// What is before the boxes. Errors: bad_input for a name or type that has a NUL or more than 127 bytes, a
/// world box that no reader would take, or counts past the format's int32.
Result<std::vector<std::byte>> aabbs_head(const RecordingHead& head);
void append_aabbs(std::vector<std::byte>& bytes, std::span<const Aabb> boxes);

/// The whole file. Errors: those of check_recording() and aabbs_head().
Result<std::vector<std::byte>> aabbs_bytes(const Recording& recording);

}  // namespace cellsweep
