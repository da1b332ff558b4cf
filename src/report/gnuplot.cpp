#include "report/gnuplot.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <string>
#include <vector>

#include "base/text.h"

extern char** environ;  // NOLINT: POSIX's name

namespace cellsweep::report {
namespace {

// The exit code of `gnuplot ARGUMENT` in a folder, its output thrown away; -1 when it could not be run.
int run_in(const std::filesystem::path& folder, std::string argument) {
  std::string program = "gnuplot";
  const std::array<char*, 3> arguments = {program.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", 0, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", 1, 0);
  // In a group of its own: a Ctrl-C is not meant for it.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t process = 0;
  const int error = posix_spawnp(&process, program.c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (error != 0 || waitpid(process, &status, 0) != process || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status);
}

}  // namespace

Status find_gnuplot() {
  if (run_in(".", "--version") == 0) return {};
  return Status::bad_input("The figures are drawn by gnuplot, and there is none (Debian: gnuplot-nox).");
}

Status run_gnuplot(const std::filesystem::path& script) {
  const std::filesystem::path folder = script.has_parent_path() ? script.parent_path() : ".";
  const int code = run_in(folder, script.filename().string());
  if (code == 0) return {};
  return Status::bad_input(text(script.string(), ": gnuplot ended with ", code, "."));
}

}  // namespace cellsweep::report
