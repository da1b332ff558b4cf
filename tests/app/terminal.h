/// @file
/// A terminal that nobody sits at, for what the command does on terminals only.
#pragma once

#include <sys/types.h>

#include <string>

namespace cellsweep::app {

/// The command with a terminal of its own as standard error, and a file as standard output.
class OnTerminal {
 public:
  /// Runs `cellsweep ARGUMENTS` through the shell.
  OnTerminal(const std::string& arguments, const std::string& output_file);
  ~OnTerminal();
  OnTerminal(const OnTerminal&) = delete;
  OnTerminal& operator=(const OnTerminal&) = delete;

  /// Waits until the terminal shows these words; false when it does not within a minute.
  bool wait_for(const std::string& words);

  /// What the key does, as often as it is pressed.
  void press_ctrl_c() const;

  /// SIGTERM, as of a system that goes down.
  void terminate() const;

  /// Waits for the end, and gives the exit code; -1 for one that was ended by a signal.
  int exit_code();

  /// All that the terminal showed until now.
  const std::string& shown() const { return shown_; }

 private:
  bool read_more();

  pid_t process_ = 0;
  int terminal_ = -1;
  std::string shown_;
};

}  // namespace cellsweep::app
