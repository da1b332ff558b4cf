/// @file
/// The command's two ways out: results on standard output, complaints on standard error; and its end.
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

/// Writes a sentence to standard error.
void say(const std::string& sentence);

/// Writes the message to standard error, with flags where it names settings, and returns the exit code that
/// goes with it.
ExitCode complain(const Status& status);

/// The exit code of a command that is done; when it was interrupted, kInterrupted or kTerminated, once
/// standard error says that and what became of the rest.
ExitCode end_with(ExitCode code, const std::string& when_interrupted);

/// The exit code of the whole program, when all that it made is gone: a good one becomes kOutputLost, or
/// another for what is wrong, once standard error says what did not reach standard output or a timeline's
/// file.
int end_of_program(int code);

}  // namespace cellsweep::app
