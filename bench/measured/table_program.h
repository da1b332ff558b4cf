/// @file
/// The main function of a program that makes tables of what a suite measured.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/status.h"

namespace cellsweep::bench {

/// Such a program: `[--docs] [FILE.json...]`.
struct TableProgram {
  std::string_view name;
  std::string_view usage;
  std::string_view file;  ///< which is read when none is named
  std::function<Status(const std::vector<std::string>& files, bool docs)> run;
};

/// Returns the exit status: 0, or 2 for bad usage and where `run` fails, whose message is printed.
int run_table_program(const TableProgram& program, int argc, char** argv);

}  // namespace cellsweep::bench
