/// @file
/// Finds and runs gnuplot.
#pragma once

#include <string>
#include <string_view>

#include "cellsweep/status.h"

namespace cellsweep::report {

/// Errors: bad_input, with what to install, when there is no gnuplot that starts.
Status find_gnuplot();

/// What a script draws on standard output. `name` is for messages, `end` what a whole picture ends with.
/// Errors: bad_input when gnuplot ends with an error, or leaves less than a whole picture; write_failed when
/// there is no room for it in memory.
Result<std::string> run_gnuplot(const std::string& name, std::string_view script, std::string_view end);

}  // namespace cellsweep::report
