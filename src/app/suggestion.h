/// @file
/// What somebody may have meant.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cellsweep::app {

/// The one of the words that takes the fewest letters to be changed, left out or put in to become; nothing
/// when all take more than a third of the letters typed, or, of short words, more than two.
std::optional<std::string> nearest(std::string_view typed, std::span<const std::string> words);

}  // namespace cellsweep::app
