// What one rank does wrong is refused by all, and nothing has changed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "cellsweep/engines.h"
#include "ranks/twins.h"

namespace cellsweep::ranks {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr Aabb kBox{{0, 0, 0}, {1, 1, 1}};

class Refusals : public testing::Test {
 protected:
  Refusals() {
    std::vector<Aabb> boxes;
    std::vector<BodyId> ids;
    for (int i = 0; i < 40; ++i) {
      const auto x = static_cast<float>(i) * 0.75F;
      ids.push_back(static_cast<BodyId>(i));
      boxes.push_back({{x, 0, 0}, {x + 1, 1, 1}});
    }
    twins_.insert(0, ids, boxes);
    EXPECT_EQ(twins_.update_and_compare(), "");
  }

  /// The update is refused on all ranks in the same words; nothing changed, and the next one goes on.
  void expect_refused(StatusCode code, const std::string& words) {
    const auto said = twins_.world().update();
    ASSERT_TRUE(on_all_ranks(!said.ok()));
    EXPECT_EQ(said.status().code, code);
    EXPECT_THAT(said.status().message, HasSubstr(words));
    EXPECT_EQ(twins_.compare_pairs(), "");
    EXPECT_EQ(twins_.update_and_compare(), "");
  }

  const int last_ = all_ranks() - 1;
  Twins twins_;
};

TEST_F(Refusals, OfABadBoxNameTheRank) {
  const GlobalId id = global_id(3);
  const Aabb bad{{0, 0, 0}, {1, std::numeric_limits<float>::quiet_NaN(), 1}};
  // What another rank says meanwhile is not lost.
  twins_.move(0, std::vector<BodyId>{7}, std::vector<Aabb>{kBox});
  if (own_rank() == last_) {
    EXPECT_EQ(twins_.world().move({&id, 1}, {&bad, 1}).code, StatusCode::invalid_box);
  }
  expect_refused(StatusCode::invalid_box, "Rank " + std::to_string(last_) + ": The box of body " +
                                              std::to_string(id) + " is refused: its y interval");
}

TEST_F(Refusals, OfABodyThatNobodyHasComeWithTheUpdate) {
  const GlobalId nobody = 12345;
  if (own_rank() == last_) {
    EXPECT_TRUE(twins_.world().move({&nobody, 1}, {&kBox, 1}).ok());
  }
  expect_refused(StatusCode::unknown_body, "Body 12345 is in no rank's world");
}

TEST_F(Refusals, OfABodyThatSomebodyHasComeAtOnceOrWithTheUpdate) {
  const GlobalId id = global_id(0);
  if (own_rank() == last_) static_cast<void>(twins_.world().insert({&id, 1}, {&kBox, 1}));
  expect_refused(StatusCode::duplicate_body, "Body 5 is in the world already");
}

TEST_F(Refusals, OfABodyThatTwoRanksNameNameOneOfThem) {
  if (all_ranks() == 1) GTEST_SKIP() << "one rank";
  const GlobalId id = global_id(20);
  if (own_rank() == 0 || own_rank() == last_) {
    EXPECT_TRUE(twins_.world().move({&id, 1}, {&kBox, 1}).ok());
  }
  const auto said = twins_.world().update();
  ASSERT_TRUE(on_all_ranks(!said.ok()));
  EXPECT_EQ(said.status().code, StatusCode::bad_input);
  EXPECT_THAT(said.status().message, HasSubstr("between two updates one rank may"));
  EXPECT_EQ(twins_.compare_pairs(), "");
}

TEST_F(Refusals, OfANewBodyThatTwoRanksInsertForgetBoth) {
  if (all_ranks() == 1) GTEST_SKIP() << "one rank";
  const GlobalId id = global_id(100);
  if (own_rank() == 0 || own_rank() == last_) {
    EXPECT_TRUE(twins_.world().insert({&id, 1}, {&kBox, 1}).ok());
  }
  expect_refused(StatusCode::bad_input, "between two updates one rank may");
}

TEST_F(Refusals, OfListsOfDifferentLength) {
  const GlobalId id = global_id(3);
  if (own_rank() == 0) {
    EXPECT_EQ(twins_.world().move({&id, 1}, {}).code, StatusCode::bad_input);
  }
  expect_refused(StatusCode::bad_input, "Rank 0: There are 1 ids but 0 boxes");
}

TEST(RankOptions, OutOfRangeAreRefusedByAll) {
  const auto made = make_distributed_broadphase(MPI_COMM_WORLD, {.recut_above = 0.5});
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.status().setting, "recut_above");
}

TEST(RankOptions, OfAnEngineThatOneRankCannotMakeAreRefusedByAll) {
  RankOptions options;
  options.make_engine = [] {
    return own_rank() == all_ranks() - 1 ? make_broadphase("no such engine") : make_broadphase("stream");
  };
  const auto made = make_distributed_broadphase(MPI_COMM_WORLD, options);
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.status().code, StatusCode::bad_option);
}

// The engines of some ranks have found their pairs when another one refuses: they take it back.
TEST(UpdatesThatAnEngineRefuses, ChangeNothingAnywhereAndGoOn) {
  RankOptions options;
  options.make_engine = [] {
    return make_broadphase(StreamOptions{.threads = 1, .max_pairs = own_rank() == 0 ? std::uint64_t{80} : 0});
  };
  options.recut_every = 2;
  Twins twins(options);
  std::vector<Aabb> boxes;
  std::vector<BodyId> ids;
  for (int i = 0; i < 40; ++i) {
    const auto x = static_cast<float>(i) * 0.9F;
    ids.push_back(static_cast<BodyId>(i));
    boxes.push_back({{x, 0, 0}, {x + 1, 1, 1}});
  }
  // Few enough pairs for one rank, too.
  twins.insert(0, std::span(ids).first(25), std::span(boxes).first(25));
  ASSERT_EQ(twins.update_and_compare(), "");
  // All come to one place, where there are more pairs than rank 0's engine may have; it may be another
  // rank's.
  std::vector<Aabb> crowd(25, Aabb{{0, 0, 0}, {1, 1, 1}});
  const std::vector<Aabb> before(boxes.begin(), boxes.begin() + 25);
  twins.move(all_ranks() - 1, std::span(ids).first(25), crowd);
  const auto said = twins.world().update();
  const bool refused = !said.ok();
  ASSERT_TRUE(on_all_ranks(refused) || on_all_ranks(!refused));
  if (refused) {
    EXPECT_EQ(said.status().code, StatusCode::capacity);
    EXPECT_EQ(twins.compare_pairs(), "");
    // New bodies, bodies that go, and the crowd disperses to other places than before.
    twins.remove(0, std::vector<BodyId>{3, 4});
    twins.insert(all_ranks() / 2, std::span(ids).subspan(25), std::span(boxes).subspan(25));
    std::vector<Aabb> away = before;
    for (Aabb& box : away) box.min[1] = box.max[1] = 0.5F;
    std::vector<BodyId> rest;
    std::vector<Aabb> places;
    for (BodyId id = 0; id < 25; ++id) {
      if (id == 3 || id == 4) continue;
      rest.push_back(id);
      places.push_back(away[24 - id]);
    }
    twins.move(all_ranks() - 1, rest, places);
    for (int frame = 0; frame < 4; ++frame) ASSERT_EQ(twins.update_and_compare(), "");
  }
}

}  // namespace
}  // namespace cellsweep::ranks
