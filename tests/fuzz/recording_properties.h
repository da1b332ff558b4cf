/// @file
/// What must hold after any bytes went through a reader of recordings; a broken property ends the process.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "cellsweep/world/recording.h"

namespace cellsweep {

/// A way to read and the way to write what was read.
struct RecordingFormat {
  Result<Recording> (*parse)(std::span<const std::byte>);
  Result<std::vector<std::byte>> (*bytes)(const Recording&);
};

/// Reads a file. Either it is refused with the byte at fault, or its boxes are sound, take no more memory
/// than the file, and come back bit for bit after being written and read again.
void check_reader(const RecordingFormat& format, std::span<const std::byte> file);

}  // namespace cellsweep
