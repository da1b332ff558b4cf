/// @file
/// Engines on SPEs in a child process: their threads are not there, so calls say so and nothing waits for
/// them.
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <optional>

#include "cellsweep/cell.h"
#include "engines/cell/cell_world.h"

namespace cellsweep::cell {
namespace {

using testing::HasSubstr;

constexpr std::array<Aabb, 2> kBoxes{{{{0, 0, 0}, {2, 2, 2}}, {{1, 1, 1}, {3, 3, 3}}}};

class EngineAfterFork : public testing::TestWithParam<const char*> {};

/// 0 if an update fails in words, and the engine can be destroyed.
int look_from_a_child(std::optional<Broadphase>& broadphase) {
  const std::array<BodyId, 1> id{1};
  if (!broadphase->move(id, std::span(kBoxes).last(1)).ok()) return 1;
  const Status status = broadphase->update().status();
  if (status.code != StatusCode::spe_failed) return 2;
  if (status.message.find("fork()") == std::string::npos) return 3;
  broadphase.reset();
  return 0;
}

TEST_P(EngineAfterFork, SaysWhyAnUpdateFailsAndIsDestroyedWithoutWaiting) {
  add_cell_engines();
  Result<Broadphase> made = make_broadphase(GetParam(), {});
  ASSERT_TRUE(made.ok()) << made.status().message;
  std::optional<Broadphase> broadphase(std::move(*made));
  const std::array<BodyId, 2> ids{1, 2};
  ASSERT_TRUE(broadphase->insert(ids, kBoxes).ok());
  ASSERT_TRUE(broadphase->update().ok());
  const pid_t child = fork();
  if (child == 0) {
    alarm(60);
    _exit(look_from_a_child(broadphase));
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  ASSERT_TRUE(broadphase->move(ids, kBoxes).ok());
  EXPECT_TRUE(broadphase->update().ok()) << "the parent's engine goes on";
}

// cell-stream compares in pieces only where there is much to compare; it runs its programs as cell-brute
// does.
INSTANTIATE_TEST_SUITE_P(Cell, EngineAfterFork, testing::Values("cell-paper", "cell-brute", "cell-resident"));

}  // namespace
}  // namespace cellsweep::cell
