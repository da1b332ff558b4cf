/// @file
/// A plugin with the library inside, loaded, used and unloaded again and again: nothing of it stays.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "held.h"

namespace cellsweep {
namespace {

constexpr int kTimes = 1000;
constexpr int kTimesToWarmUp = 50;
constexpr unsigned kBodies = 20000;  // enough work for all threads

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
