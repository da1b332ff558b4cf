/// @file
/// A plugin with the library inside, loaded, used and unloaded again and again: nothing of it stays.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace cellsweep {
namespace {

constexpr int kTimes = 1000;
constexpr int kTimesToWarmUp = 50;
constexpr unsigned kBodies = 20000;  // enough work for all threads

std::size_t entries(const char* folder) {
  return static_cast<std::size_t>(
      std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

/// What a process has of its system.
struct Held {
  std::size_t threads = entries("/proc/self/task");
  std::size_t files = entries("/proc/self/fd");
  std::size_t mappings = count_lines("/proc/self/maps");
  std::size_t kilobytes = resident_kilobytes();

  static std::size_t count_lines(const char* path) {
    std::ifstream file(path);
    return static_cast<std::size_t>(
        std::count(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>(), '\n'));
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

void use_once(unsigned bodies) {
  void* plugin = dlopen(CELLSWEEP_PLUGIN, RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(plugin, nullptr) << dlerror();
  const auto count_pairs = reinterpret_cast<long (*)(unsigned)>(dlsym(plugin, "count_pairs_of_row"));
  ASSERT_NE(count_pairs, nullptr);
  ASSERT_EQ(count_pairs(bodies), static_cast<long>(bodies) - 1);
  ASSERT_EQ(dlclose(plugin), 0);
  ASSERT_EQ(dlopen(CELLSWEEP_PLUGIN, RTLD_NOW | RTLD_NOLOAD), nullptr) << "it was not unloaded";
}

TEST(Plugin, LeavesNothingBehindWhenItIsUnloaded) {
  for (int i = 0; i < kTimesToWarmUp; ++i) ASSERT_NO_FATAL_FAILURE(use_once(i % 10 == 0 ? kBodies : 10));
  const Held before;
  for (int i = 0; i < kTimes; ++i) ASSERT_NO_FATAL_FAILURE(use_once(i % 10 == 0 ? kBodies : 10));
  const Held after;
  EXPECT_EQ(after.threads, before.threads);
  EXPECT_EQ(after.files, before.files);
  EXPECT_LE(after.mappings, before.mappings + 10);
  EXPECT_LE(after.kilobytes, before.kilobytes + 4096);
  // Nothing of it is called any more.
  const pid_t child = fork();
  if (child == 0) _exit(0);
  int status = 0;
  EXPECT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace cellsweep
