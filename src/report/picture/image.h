/// @file
/// A picture in memory, and as a PNG file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "cellsweep/status.h"

namespace cellsweep::report {

/// Rows from the top, three bytes a pixel: red, green, blue (sRGB).
struct Image {
  unsigned width = 0;
  unsigned height = 0;
  std::vector<std::uint8_t> rgb;
};

/// The bytes of a PNG file of a picture with at least one pixel. The same picture gives the same bytes.
std::string png_of(const Image& image);

/// Writes a PNG file, whole or not at all. Errors: those of write_text_file().
Status write_png(const Image& image, const std::filesystem::path& path);

}  // namespace cellsweep::report
