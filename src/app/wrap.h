/// @file
/// Text in lines that fit a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cellsweep::app {

/// The columns that all help fits into.
inline constexpr std::size_t kColumns = 80;

/// The text in lines of at most kColumns, broken between words, behind what fills the first line up to column
/// `start`; each further line begins with `indent` blanks. Line breaks in the text stay.
std::string wrapped(std::string_view text, std::size_t start = 0, std::size_t indent = 0);

}  // namespace cellsweep::app
