/// @file
/// Questions that do not get the memory or the threads that they ask for: nothing has changed, and asked
/// again they have their answers.
#include "contract/faults/questions.h"

#include <gtest/gtest.h>

#include "broadphase/last_update.h"
#include "cellsweep/engine/engine.h"
#include "contract/checked_engine.h"
#include "contract/contract_fixture.h"
#include "contract/effort.h"
#include "contract/faults/starved_call.h"

namespace cellsweep::contract {
namespace {

/// So few that no update of theirs starts a thread: batches of questions do.
constexpr std::size_t kFewAsked = 40;
/// For cells within cells, and a tree that questions pay for.
constexpr std::size_t kManyAsked = effort(std::size_t{3000}, 2100, 2100);

/// Bodies, and a call that waits for the next update.
class AskedWorld {
 public:
  AskedWorld(const ContractEngine& engine, std::size_t bodies)
      : checked_(engine, "asked with faults"), random_(3) {
    bodies = std::min(bodies, checked_.capacity() / 2);
    for (BodyId i = 0; i < bodies; ++i) ids_.push_back(i % 2 == 0 ? i : 0xffffff00U - 1001 * i);
    boxes_ = make_boxes(box_kind("uniform"), random_, bodies);
    EXPECT_TRUE(checked_.insert(ids_, boxes_));
    change();
  }

  /// Bodies go, and come again as they were: what is only made when it is needed is not there any more.
  void change() {
    EXPECT_TRUE(checked_.remove({ids_[1], ids_[2]}));
    EXPECT_TRUE(checked_.update());
    EXPECT_TRUE(checked_.insert({ids_[2], ids_[1]}, {boxes_[2], boxes_[1]}));
    EXPECT_TRUE(checked_.update());
    EXPECT_TRUE(checked_.move({ids_[0]}, {boxes_[0]}));
  }

  testing::AssertionResult is_kept() { return checked_.state_is_kept(); }
  void forget_tree() const { EngineAccess::last_update(checked_.engine()).tree.drop(); }
  bool has_tree() const { return EngineAccess::last_update(checked_.engine()).tree.get() != nullptr; }
  Queries queries() const { return checked_.engine().queries(); }
  queries::Reference reference() const { return {checked_.model().shown, checked_.model().filters}; }

 private:
  CheckedEngine checked_;
  Random random_;
  std::vector<BodyId> ids_;
  std::vector<Aabb> boxes_;
};

testing::AssertionResult looks_well(AskedWorld& world, const Question& question, bool answered) {
  if (answered && !question.is_right()) return testing::AssertionFailure() << question.name << " is wrong";
  return world.is_kept() << " after " << question.name;
}

class QuestionFaults : public PerEngine {
 protected:
  void TearDown() override { count_calls(false); }

  static std::uint64_t seeds() { return is_interpreted(GetParam()) ? 1 : repeated(6, effort(2, 1, 1)); }
};

TEST_P(QuestionFaults, WithoutMemoryChangeNothingAndHaveTheirAnswersWhenTheyAreAskedAgain) {
  AskedWorld world(GetParam(), kFewAsked);
  std::uint64_t faults = 0;
  for (std::uint64_t seed = 0; seed < seeds(); ++seed) {
    const queries::Reference reference = world.reference();
    for (const Question& question : make_questions(world.queries(), reference, seed)) {
      for (const Lasts lasts : {Lasts::once, Lasts::for_ever}) {
        faults += starve_each(
            Scarce::memory, lasts,
            [&] {
              if (!is_interpreted(GetParam())) world.change();
            },
            question.ask, [&](bool answered) { return looks_well(world, question, answered); },
            {.each_of_first = effort(30U, 10U, 10U), .then_one_in = repeated(3U, effort(11U, 23U, 23U))});
        if (HasFailure()) return;
      }
    }
  }
  EXPECT_GT(faults, 20U) << "questions ask for memory in fewer places than there are";
}

// The first that has several threads' work starts them.
TEST_P(QuestionFaults, WithoutThreadsDoWithout) {
  std::uint64_t faults = 0;
  for (const Lasts lasts : {Lasts::once, Lasts::for_ever}) {
    std::optional<AskedWorld> world;
    std::vector<Question> questions;
    const auto begin = [&] {
      world.emplace(GetParam(), kFewAsked);
      questions = make_questions(world->queries(), world->reference(), 0);
    };
    const auto ask_all = [&] {
      Status status;
      for (const Question& question : questions) status = status.ok() ? question.ask() : status;
      return status;
    };
    const auto look = [&](bool answered) {
      if (!answered) return testing::AssertionFailure() << "questions need threads";
      testing::AssertionResult right = world->is_kept();
      for (const Question& question : questions) {
        if (right) right = looks_well(*world, question, answered);
      }
      return right;
    };
    faults += starve_each(Scarce::threads, lasts, begin, ask_all, look);
  }
  EXPECT_TRUE(faults > 0 || GetParam().label != "stream_with_three_threads_and_a_margin")
      << "no thread was started";
}

TEST_P(QuestionFaults, WithoutMemoryForTheTreeGoOnAndItIsMadeWhenItIsAskedForAgain) {
  AskedWorld world(GetParam(), kFewAsked);
  const queries::Reference reference = world.reference();
  const std::vector<Question> questions = make_questions(world.queries(), reference, 7);
  const auto prepare = [&] {
    world.queries().prepare();
    return Status();
  };
  for (const Lasts lasts : {Lasts::once, Lasts::for_ever}) {
    const auto look = [&](bool prepared) -> testing::AssertionResult {
      if (world.has_tree() != prepared) return testing::AssertionFailure() << "a tree is there or is not";
      for (const Question& question : questions) {
        if (!gets_all(question.ask) || !question.is_right())
          return testing::AssertionFailure() << question.name << " is wrong";
      }
      return world.is_kept();
    };
    const auto without_tree = [&] {
      world.change();
      world.forget_tree();
    };
    EXPECT_GT(starve_each(Scarce::memory, lasts, without_tree, prepare, look), 1U);
    const auto with_outdated_tree = [&] {
      world.queries().prepare();
      world.change();
    };
    EXPECT_GT(starve_each(Scarce::memory, lasts, with_outdated_tree, prepare, look), 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(Engines, QuestionFaults, all_engines(), engine_label);

/// Where there are cells within cells, and trees that questions pay for.
class FaultsAmongMany : public testing::Test {
 protected:
  void TearDown() override { count_calls(false); }

  static ContractEngine engine() {
    return {"stream", [] { return make_broadphase(StreamOptions{.threads = effort(3U, 2U, 1U)}); }, "stream"};
  }

  AskedWorld world_{engine(), kManyAsked};
  queries::Reference reference_ = world_.reference();
};

TEST_F(FaultsAmongMany, WithoutMemoryQuestionsChangeNothing) {
  for (const bool with_tree : {false, true}) {
    world_.change();
    if (with_tree) world_.queries().prepare();
    for (const Question& question : make_questions(world_.queries(), reference_, 1)) {
      for (const Lasts lasts : {Lasts::once, Lasts::for_ever}) {
        if (kPace == Pace::sanitized && !is_long() && with_tree == (lasts == Lasts::once)) continue;
        starve_each(
            Scarce::memory, lasts, [] {}, question.ask,
            [&](bool answered) { return looks_well(world_, question, answered); },
            {.each_of_first = effort(15U, 4U, 4U), .then_one_in = repeated(3U, effort(17U, 37U, 37U))});
        if (HasFailure()) return;
      }
    }
  }
}

/// The path along all bodies, of which each question pays a part of the tree's price.
TEST_F(FaultsAmongMany, AQuestionThatHasPaidForATreeDoesWithoutTheMemoryForIt) {
  const Path far(MovingBox{{{-1e6F, -1e6F, -1e6F}, {-1e6F, 1e6F, 1e6F}}, {1, 0, 0}, 1e7});
  const std::vector<Touch> truth = reference_.touches(far);
  ASSERT_EQ(truth.size(), kManyAsked);
  std::vector<Touch> found;
  const auto ask = [&] { return world_.queries().find_touches(far, found); };
  int questions = 0;
  world_.change();
  for (world_.forget_tree(); !world_.has_tree(); ++questions) ASSERT_TRUE(ask().ok());
  ASSERT_GT(questions, 2);
  const auto pay_nearly_all = [&] {
    world_.change();
    world_.forget_tree();
    for (int i = 1; i < questions; ++i) EXPECT_TRUE(ask().ok());
    EXPECT_FALSE(world_.has_tree());
  };
  for (const Lasts lasts : {Lasts::once, Lasts::for_ever}) {
    const auto look = [&](bool answered) -> testing::AssertionResult {
      if (answered && found != truth) return testing::AssertionFailure() << "find_touches is wrong";
      return world_.is_kept();
    };
    EXPECT_GT(starve_each(Scarce::memory, lasts, pay_nearly_all, ask, look), 1U);
    EXPECT_TRUE(world_.has_tree()) << "the last one had all memory";
  }
}

}  // namespace
}  // namespace cellsweep::contract
