#include "report/gnuplot.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

#include "base/text.h"

extern char** environ;  // NOLINT: POSIX's name

namespace cellsweep::report {
namespace {

/// A file in memory: gone with this object, or the program.
class MemoryFile {
 public:
  MemoryFile() : file_(::memfd_create("cellsweep", MFD_CLOEXEC)) {}
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() {
    if (file_ >= 0) ::close(file_);
  }

  int number() const { return file_; }

  bool write(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t count = ::write(file_, bytes.data(), bytes.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return ::lseek(file_, 0, SEEK_SET) == 0;
  }

  bool read(std::string& bytes) const {
    std::array<char, 65536> part{};
    for (off_t at = 0;;) {
      const ssize_t count = ::pread(file_, part.data(), part.size(), at);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return count == 0;
      bytes.append(part.data(), static_cast<std::size_t>(count));
      at += count;
    }
  }

 private:
  int file_;
};

void open_stream(posix_spawn_file_actions_t& actions, int stream, int file, int mode) {
  if (file >= 0) {
    posix_spawn_file_actions_adddup2(&actions, file, stream);
  } else {
    posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", mode, 0);
  }
}

// The exit code of `gnuplot ARGUMENT` with these files, or none where negative, as its standard input and
// output; -1 when it could not be run.
int run(std::string argument, int input, int output) {
  std::string program = "gnuplot";
  const std::array<char*, 3> arguments = {program.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  open_stream(actions, STDIN_FILENO, input, O_RDONLY);
  open_stream(actions, STDOUT_FILENO, output, O_WRONLY);
  // In a group of its own: a Ctrl-C is not meant for it. What the command ignores ends it as any program.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF);
  sigset_t as_usual;
  sigemptyset(&as_usual);
  for (const int signal : {SIGPIPE, SIGXFSZ}) sigaddset(&as_usual, signal);
  posix_spawnattr_setsigdefault(&attributes, &as_usual);
  pid_t process = 0;
  const int error = posix_spawnp(&process, program.c_str(), &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (error != 0 || waitpid(process, &status, 0) != process || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status);
}

Status no_room(const std::string& name) {
  Status status = Status::bad_input(
      text(name, ": there is no room to draw it: ", std::generic_category().message(errno), "."));
  status.code = StatusCode::write_failed;
  return status;
}

}  // namespace

Status find_gnuplot() {
  if (run("--version", -1, -1) == 0) return {};
  return Status::bad_input("The figures are drawn by gnuplot, and there is none (Debian: gnuplot-nox).");
}

Result<std::string> run_gnuplot(const std::string& name, std::string_view script, std::string_view end) {
  const MemoryFile input;
  const MemoryFile output;
  if (!input.write(script) || output.number() < 0) return no_room(name);
  const int code = run("-", input.number(), output.number());
  if (code != 0) return Status::bad_input(text(name, ": gnuplot ended with ", code, "."));
  std::string picture;
  if (!output.read(picture)) return no_room(name);
  if (!std::string_view(picture).ends_with(end))
    return Status::bad_input(text(name, ": gnuplot left less than a whole picture."));
  return picture;
}

}  // namespace cellsweep::report
