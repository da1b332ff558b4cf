/// @file
/// Whole files: written at once or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>

#include "cellsweep/status.h"

namespace cellsweep {

/// bad_input: "PATH: reason".
Status refusal_of_file(const std::filesystem::path& path, std::string_view reason);

/// Writes another file and gives it this name when it is whole. Errors: those of NewFile.
Status write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

}  // namespace cellsweep
