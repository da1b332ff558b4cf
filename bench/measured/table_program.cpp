#include "bench/measured/table_program.h"

#include <cstdio>

#include "base/text.h"

namespace cellsweep::bench {

int run_table_program(const TableProgram& program, int argc, char** argv) {
  std::vector<std::string> files;
  bool docs = false;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--docs") {
      docs = true;
    } else if (argument.starts_with("-")) {
      std::fputs(program.usage.data(), argument == "--help" ? stdout : stderr);
      return argument == "--help" ? 0 : 2;
    } else {
      files.emplace_back(argument);
    }
  }
  if (files.empty()) files.emplace_back(program.file);
  const Status status = program.run(files, docs);
  if (status.ok()) return 0;
  std::fputs(text(program.name, ": ", status.message, "\n").c_str(), stderr);
  return 2;
}

}  // namespace cellsweep::bench
