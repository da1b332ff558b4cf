/// @file
/// Writes a file from memory.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "cellsweep/status.h"

namespace cellsweep::report {

/// Writes the bytes as they are, in the place of what was there, whole or not at all. Errors, with the path:
/// bad_input where nothing can be written, write_failed for a disk that says no.
Status write_text_file(const std::filesystem::path& path, std::string_view bytes);

/// The bytes of a file. Errors: bad_input, with the path.
Result<std::string> read_text_file(const std::filesystem::path& path);

/// Makes a folder and those it lies in, unless it is there. Errors: bad_input, with the path.
Status make_folder(const std::filesystem::path& path);

}  // namespace cellsweep::report
