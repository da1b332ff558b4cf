/// @file
/// fork(): the child has none of its parent's threads, and uses every engine all the same, or is told why
/// not.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <vector>

#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/random_caller.h"

namespace cellsweep::contract {
namespace {

constexpr std::size_t kBodies = 200;
constexpr unsigned kSecondsOfChild = 60;

/// Runs `work` in a child of this process and says whether it answered true. A child that hangs is killed.
template <class Work>
testing::AssertionResult child_succeeds(const Work& work) {
  std::cout.flush();
  const pid_t child = fork();
  if (child == 0) {
    alarm(kSecondsOfChild);
    const testing::AssertionResult result = work();
    if (!result) std::cerr << "in the child: " << result.message() << std::endl;
    _exit(result ? 0 : 1);
  }
  int status = 0;
  if (waitpid(child, &status, 0) != child) return testing::AssertionFailure() << "there is no child";
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "the child ended with status " << status;
}

using ForkContract = PerEngine;

/// Embree shares threads among all that it makes in a process.
bool works_in_a_child(const ContractEngine& engine) {
  return engine.name != "embree";
}

/// What a child does with a broadphase that its parent has used, until it is destroyed.
testing::AssertionResult use_up(CheckedEngine checked, const BoxKind& kind) {
  RandomCaller caller(checked, kind, std::min(kBodies, checked.capacity()), 2);
  for (int step = 0; step < 6; ++step) {
    if (testing::AssertionResult right = caller.step(); !right) return right;
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult is_told_why_not(CheckedEngine checked) {
  if (testing::AssertionResult added = checked.insert({0xffffffff}, {Aabb{}}); !added) return added;
  Status status;
  if (testing::AssertionResult refused = checked.refuse_update(status); !refused) return refused;
  if (status.message.find("fork()") != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << status.message;
}

TEST_P(ForkContract, TheChildGoesOnWithTheParentsEngineAndSoDoesTheParent) {
  const BoxKind& kind = box_kind("uniform");
  CheckedEngine checked(GetParam(), "forked");
  RandomCaller caller(checked, kind, std::min(kBodies, checked.capacity()), 1);
  ASSERT_TRUE(caller.fill());
  ASSERT_TRUE(caller.step());
  EXPECT_TRUE(child_succeeds([&] {
    return works_in_a_child(GetParam()) ? use_up(std::move(checked), kind)
                                        : is_told_why_not(std::move(checked));
  }));
  for (int step = 0; step < 3; ++step) ASSERT_TRUE(caller.step());
}

TEST_P(ForkContract, TheChildMayDestroyWhatItsParentMade) {
  CheckedEngine checked(GetParam(), "forked and destroyed");
  ASSERT_TRUE(checked.insert({1, 2}, std::vector<Aabb>(2, Aabb{{0, 0, 0}, {1, 1, 1}})));
  ASSERT_TRUE(checked.update());
  EXPECT_TRUE(child_succeeds([&] {
    const CheckedEngine destroyed(std::move(checked));
    return testing::AssertionSuccess();
  }));
  ASSERT_TRUE(checked.remove({1}));
  ASSERT_TRUE(checked.update());
}

TEST_P(ForkContract, TheChildMakesEnginesOfItsOwn) {
  if (!works_in_a_child(GetParam())) return;
  EXPECT_TRUE(child_succeeds([&] { return use_up({GetParam(), "made in a child"}, box_kind("uniform")); }));
}

INSTANTIATE_TEST_SUITE_P(Engines, ForkContract, all_engines(), engine_label);

}  // namespace
}  // namespace cellsweep::contract
