/// @file
/// The subcommands. Each function adds its command to the program; when the command is chosen it runs and
/// leaves its exit code.
#pragma once

#include <CLI/CLI.hpp>

#include "app/exit_code.h"

namespace cellsweep::app {

void add_simulate(CLI::App& program, ExitCode& exit_code);
void add_replay(CLI::App& program, ExitCode& exit_code);
void add_record(CLI::App& program, ExitCode& exit_code);
void add_verify(CLI::App& program, ExitCode& exit_code);
void add_query(CLI::App& program, ExitCode& exit_code);
void add_engines(CLI::App& program, ExitCode& exit_code);
void add_local_store(CLI::App& program, ExitCode& exit_code);
void add_experiment(CLI::App& program, ExitCode& exit_code);
void add_render(CLI::App& program, ExitCode& exit_code);
void add_view(CLI::App& program, ExitCode& exit_code);
void add_demo(CLI::App& program, ExitCode& exit_code);

}  // namespace cellsweep::app
