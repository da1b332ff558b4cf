/// @file
/// The command as a whole: its subcommands, its help, and what it says to arguments that it does not know.
#pragma once

namespace cellsweep::app {

/// Runs what the arguments ask for and returns the exit code. Engines are those of the table.
int run_program(int argc, char** argv);

}  // namespace cellsweep::app
