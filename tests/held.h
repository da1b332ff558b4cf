/// @file
/// What a process has of its system.
#pragma once

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace cellsweep {

/// As of when it is made.
struct Held {
  std::size_t threads = entries("/proc/self/task");
  std::size_t files = entries("/proc/self/fd");
  std::size_t mappings = count_lines("/proc/self/maps");
  std::size_t kilobytes = resident_kilobytes();

  static std::size_t entries(const char* folder) {
    const std::filesystem::directory_iterator all(folder);
    return static_cast<std::size_t>(std::distance(begin(all), end(all)));
  }
  static std::size_t count_lines(const char* path) {
    std::ifstream file(path);
    using Bytes = std::istreambuf_iterator<char>;
    return static_cast<std::size_t>(std::count(Bytes(file), Bytes(), '\n'));
  }
  static std::size_t resident_kilobytes() {
    std::ifstream file("/proc/self/status");
    for (std::string word; file >> word;) {
      std::size_t kilobytes = 0;
      if (word == "VmRSS:" && file >> kilobytes) return kilobytes;
    }
    return 0;
  }
};

}  // namespace cellsweep
