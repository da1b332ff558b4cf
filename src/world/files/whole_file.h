/// @file
/// Whole files: read at once, written at once or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "cellsweep/status.h"

namespace cellsweep {

/// bad_input: "PATH: reason".
Status refusal_of_file(const std::filesystem::path& path, std::string_view reason);

/// Errors: bad_input, with the path in front, for what cannot be read or is no file.
Result<std::vector<std::byte>> read_file(const std::filesystem::path& path);

/// Writes another file and gives it this name when it is whole. Errors: those of NewFile.
Status write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

}  // namespace cellsweep
