/// @file
/// What the program of a suite does once its rows are registered.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cellsweep::bench {

/// Runs the rows as Google Benchmark's options say: the defaults, then the caller's. With the results stand
/// CPU, compiler, flags and commit. They go into file `out`, too, unless it is empty or rows are chosen or
/// listed. Returns the program's exit status.
int run_rows(int argc, char** argv, std::vector<std::string> defaults, const std::filesystem::path& out = {});

}  // namespace cellsweep::bench
