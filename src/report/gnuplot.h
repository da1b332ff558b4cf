/// @file
/// Finds and runs gnuplot.
#pragma once

#include <filesystem>

#include "cellsweep/status.h"

namespace cellsweep::report {

/// Errors: bad_input, with what to install, when there is no gnuplot that starts.
Status find_gnuplot();

/// Runs a script, in the folder that it lies in. Errors: bad_input, with the script's path, when gnuplot ends
/// with an error; what it says goes to standard error.
Status run_gnuplot(const std::filesystem::path& script);

}  // namespace cellsweep::report
