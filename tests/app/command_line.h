/// @file
/// Runs the built `cellsweep` command as a user would.
#pragma once

#include <filesystem>
#include <string>

namespace cellsweep::app {

/// The exit code of a command whose output cannot be written.
inline constexpr int kOutputLost = 6;

struct CommandResult {
  int exit_code = -1;
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

/// Runs `cellsweep ARGUMENTS` through the shell, with `environment` ("NAME=VALUE ...") in front and a file as
/// its standard input.
CommandResult run_command(const std::string& arguments, const std::string& environment = {},
                          const std::string& input = "/dev/null");

/// What is in a file; nothing where there is none.
std::string contents(const std::filesystem::path& path);

/// A folder of this test's own, empty at the start and removed at the end.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  std::string path(const std::string& file) const { return (folder_ / file).string(); }

 private:
  std::filesystem::path folder_;
};

}  // namespace cellsweep::app
