/// @file
/// Writing Broadmark's .aabbs; reading it is parse_aabbs() of the public face.
#pragma once

#include <cstddef>
#include <vector>

#include "cellsweep/status.h"
#include "cellsweep/world/recording.h"

namespace cellsweep {

/// The whole file. Errors: those of check_recording(), and bad_input for a name or type that has a NUL or
/// more than 127 bytes, a world box that no reader would take, or counts past the format's int32.
Result<std::vector<std::byte>> aabbs_bytes(const Recording& recording);

}  // namespace cellsweep
