/// @file
/// A line on a terminal that says how far a long piece of work has come.
#pragma once

#include <chrono>
#include <cstddef>
#include <limits>
#include <string>

namespace cellsweep::report {

/// Writes to standard error, only when that is a terminal, and not more than ten times a second. The line is
/// wiped when the object goes.
class Progress {
 public:
  /// For work whose end is not known before.
  static constexpr std::size_t kOpenEnd = std::numeric_limits<std::size_t>::max();

  Progress(std::string what, std::size_t total);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` of the total are done.
  void show(std::size_t done);

 private:
  std::string what_;
  std::size_t total_;
  bool on_terminal_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace cellsweep::report
