/// @file
/// Pieces of an HTML page that needs nothing from elsewhere.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cellsweep::report {

/// The words with what HTML gives a meaning to made harmless.
std::string html_text(std::string_view words);

/// An element with content that is HTML already.
std::string html_element(std::string_view name, std::string_view content, std::string_view attributes = {});

/// A table; the first row is its head. Cells are plain words.
std::string html_table(const std::vector<std::vector<std::string>>& rows);

/// Names and values, one line each, of plain words.
std::string html_list(const std::vector<std::pair<std::string, std::string>>& entries);

/// An SVG file as an element of a page: without the lines in front of it and the names of its formats, which
/// in HTML go without saying. Empty for a file that is none.
std::string inline_svg(std::string_view file, std::string_view description);

/// Bytes as they stand in a data URI.
std::string base64(std::string_view bytes);

}  // namespace cellsweep::report
