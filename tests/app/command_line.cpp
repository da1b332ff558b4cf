#include "command_line.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>

#include "base/text.h"

namespace cellsweep::app {
namespace {

/// The address sanitizer says once that it does not know fibers to the end, which is not the command's word.
std::string without_sanitizer_notes(const std::string& errors) {
  return std::regex_replace(errors, std::regex("==[0-9]+==WARNING: ASan [^\n]*\n"), "");
}

}  // namespace

std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

ScratchFolder::ScratchFolder() {
  static int made = 0;
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  folder_ =
      std::filesystem::temp_directory_path() / ("cellsweep-" + std::string(test->name()) + "-" +
                                                std::to_string(getpid()) + "-" + std::to_string(++made));
  std::filesystem::create_directories(folder_);
}

ScratchFolder::~ScratchFolder() {
  std::filesystem::remove_all(folder_);
}

CommandResult run_command(const std::string& arguments, const std::string& environment,
                          const std::string& input) {
  const ScratchFolder scratch;
  const std::string line = text(environment, " ", CELLSWEEP_COMMAND, " ", arguments, " >",
                                scratch.path("output"), " 2>", scratch.path("errors"), " <", input);
  const int status = std::system(line.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(scratch.path("output")),
          without_sanitizer_notes(contents(scratch.path("errors")))};
}

}  // namespace cellsweep::app
