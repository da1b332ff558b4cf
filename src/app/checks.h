/// @file
/// What values of flags may be; others are refused in words.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <vector>

#include "cellsweep/status.h"

namespace cellsweep::app {

/// More threads than any machine has are a slip of the fingers.
inline constexpr std::uint64_t kMostThreads = 1024;

/// A whole number in a range, both ends included.
CLI::Validator count(std::uint64_t least = 0, std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// A finite number in a range, both ends included.
CLI::Validator number(double least, double most = std::numeric_limits<double>::infinity());

/// One of some words.
CLI::Validator one_of(std::vector<std::string_view> words);

/// Whether a file can be written as one of these, by its ending. Errors: bad_input.
Status check_ending(const std::filesystem::path& file, std::initializer_list<std::string_view> endings);

}  // namespace cellsweep::app
