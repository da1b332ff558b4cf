/// @file
/// The command's two ways out: results on standard output, complaints on standard error.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "app/exit_code.h"
#include "cellsweep/status.h"

namespace cellsweep::app {

/// Writes text to standard output.
void print_text(const std::string& text);

/// Writes one JSON object to standard output.
void print_json(const nlohmann::ordered_json& json);

/// Writes the message to standard error and returns the exit code that goes with it.
ExitCode complain(const Status& status);

}  // namespace cellsweep::app
