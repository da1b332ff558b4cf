#include <gtest/gtest.h>

#include <set>
#include <string>

#include "bench/queries/query_check.h"
#include "bench/queries/query_peer.h"
#include "bench/queries/query_stage.h"
#include "bench/queries/query_world.h"
#include "bench/queries/table/query_tables.h"
#include "contract/effort.h"

namespace cellsweep::bench {
namespace {

bool can_be_asked(const QueryPeerInfo& peer, std::string_view world, QuestionKind kind) {
  return peer.does_answer(kind) && (!peer.only_points || has_only_points(world));
}

TEST(QueryPeers, HaveNamesOfTheirOwnAndTheFirstOneAnswersEverything) {
  std::set<std::string_view> names;
  for (const QueryPeerInfo& peer : query_peer_table()) {
    EXPECT_TRUE(names.insert(peer.name).second) << peer.name;
    EXPECT_EQ(peer.name.find('/'), std::string_view::npos) << peer.name;
    EXPECT_FALSE(peer.settings.empty()) << peer.name;
  }
  EXPECT_EQ(query_peer_table().front().name, "stream");
  EXPECT_EQ(query_peer_table().front().answers.size(), kQuestionKinds.size());
}

// The stage compares the first one with what looking at all boxes finds, and the others with the first one.
TEST(QueryPeers, AnswerEveryKindOfQuestionInEveryWorldAsLookingAtAllBoxesDoes) {
  const std::size_t bodies = contract::effort(3000, 300, 300);
  for (const std::string_view world : kQueryWorlds) {
    QueryStage stage({std::string(world), bodies, contract::effort(160, 80, 80)});
    for (const QueryPeerInfo& peer : query_peer_table()) {
      for (const QuestionKindInfo& kind : kQuestionKinds) {
        // Boxes of trees in floats that are points or planes may be missed by rays.
        if (!can_be_asked(peer, world, kind.kind) || (has_only_points(world) && is_ray(kind.kind))) continue;
        EXPECT_EQ(stage.fault(peer, kind.kind), "") << peer.name << ", " << world << ", " << kind.name;
      }
    }
  }
}

TEST(QueryPeers, AnswerForWhereBodiesHaveMovedTo) {
  const std::size_t bodies = contract::effort(3000, 300, 300);
  for (const std::string_view name : {"varied", "ground", "points"}) {
    for (const QueryPeerInfo& peer : query_peer_table()) {
      QueryWorld world(name, bodies, 1);
      const auto asked = peer.make();
      asked->build(world.boxes());
      for (int i = 0; i < 3; ++i) {
        const std::span<const BodyId> moved = world.advance(i == 1 ? 10 : 1);
        asked->move(moved);
      }
      const QuestionSizes sizes = find_sizes(world.boxes(), world.bounds());
      for (const QuestionKind kind : {QuestionKind::boxes, QuestionKind::nearest8}) {
        if (!can_be_asked(peer, name, kind)) continue;
        const Questions questions = make_questions(kind, 50, world.boxes(), world.bounds(), sizes, 1);
        const Answers truth = answer_by_looking_at_all(questions, world.boxes(), 50);
        EXPECT_EQ(find_fault(ask_all(*asked, peer, questions), truth, questions, world.boxes(),
                             slack_of(world.bounds())),
                  "")
            << peer.name << ", " << name;
      }
    }
  }
}

TEST(Questions, AreTheSameForASeedAndFindAsManyAsTheirKindSays) {
  const QueryWorld world("uniform", 4000, 1);
  const QuestionSizes sizes = find_sizes(world.boxes(), world.bounds());
  const auto make = [&](QuestionKind kind, std::uint64_t seed) {
    return make_questions(kind, 200, world.boxes(), world.bounds(), sizes, seed);
  };
  EXPECT_EQ(make(QuestionKind::boxes, 3).boxes, make(QuestionKind::boxes, 3).boxes);
  EXPECT_NE(make(QuestionKind::boxes, 3).boxes, make(QuestionKind::boxes, 4).boxes);
  const auto mean_found = [&](QuestionKind kind) {
    return static_cast<double>(answer_by_looking_at_all(make(kind, 1), world.boxes(), 200).answers.size()) /
           200;
  };
  EXPECT_NEAR(mean_found(QuestionKind::boxes), 4, 1);
  EXPECT_NEAR(mean_found(QuestionKind::big_boxes), 100, 20);
  EXPECT_NEAR(mean_found(QuestionKind::radius), 16, 4);
}

/// Four cubes in a row, and a ray along them.
class QueryCheck : public testing::Test {
 protected:
  static constexpr double kSlack = 1e-5;

  static Aabb cube_at(float x) { return {{x, 0, 0}, {x + 1, 1, 1}}; }

  Questions ask_for(QuestionKind kind) const {
    Questions questions;
    questions.kind = kind;
    questions.rays = {{{-1, 0.5F, 0.5F}, {1, 0, 0}, 100}};
    questions.boxes = {{{-0.5F, 0, 0}, {2.5F, 0, 0}}};
    return questions;
  }
  std::string fault(QuestionKind kind, const std::vector<Neighbor>& answers) const {
    const Questions questions = ask_for(kind);
    const Answers given{{0, answers.size()}, answers};
    return find_fault(given, answer_by_looking_at_all(questions, boxes_, 1), questions, boxes_, kSlack);
  }

  std::vector<Aabb> boxes_ = {cube_at(0), cube_at(2), cube_at(4), cube_at(6)};
};

TEST_F(QueryCheck, DeniesBodiesThatAreMissingOrTooManyOrNamedTwice) {
  EXPECT_EQ(fault(QuestionKind::boxes, {{1, 0}, {0, 0}}), "");
  EXPECT_NE(fault(QuestionKind::boxes, {{0, 0}}), "");
  EXPECT_NE(fault(QuestionKind::boxes, {{0, 0}, {1, 0}, {2, 0}}), "");
  EXPECT_NE(fault(QuestionKind::boxes, {{0, 0}, {1, 0}, {1, 0}}), "");
  EXPECT_NE(fault(QuestionKind::boxes, {{0, 0}, {7, 0}}), "");
}

TEST_F(QueryCheck, LetsTimesAndDistancesDifferByTheSlackAndNoMore) {
  EXPECT_EQ(fault(QuestionKind::rays, {{0, 1 + 1e-6}}), "");
  EXPECT_NE(fault(QuestionKind::rays, {{0, 1.001}}), "");
  EXPECT_NE(fault(QuestionKind::rays, {{1, 3}}), "");
  EXPECT_NE(fault(QuestionKind::rays, {{1, 1}}), "");
  EXPECT_NE(fault(QuestionKind::rays, {}), "");
  EXPECT_EQ(fault(QuestionKind::any, {{}}), "");
  EXPECT_NE(fault(QuestionKind::any, {}), "");
  EXPECT_EQ(fault(QuestionKind::all, {{3, 7}, {2, 5}, {1, 3}, {0, 1}}), "");
  EXPECT_NE(fault(QuestionKind::all, {{3, 7}, {2, 5}, {1, 3}, {0, 1.1}}), "");
  EXPECT_NE(fault(QuestionKind::all, {{3, 7}, {2, 5}, {1, 3}}), "");
  EXPECT_EQ(fault(QuestionKind::nearest1, {{1, 0}}), "") << "it is as near as the first";
  EXPECT_NE(fault(QuestionKind::nearest1, {{2, 1.5}}), "");
  EXPECT_NE(fault(QuestionKind::nearest1, {{2, 0}}), "") << "its distance is another";
}

TEST_F(QueryCheck, LetsARayInFloatsMissABoxThatItOnlyGrazes) {
  boxes_.front() = {{0, 0.5F, 0}, {1, 1, 1}};
  EXPECT_EQ(fault(QuestionKind::rays, {{1, 3}}), "");
  EXPECT_EQ(fault(QuestionKind::all, {{1, 3}, {2, 5}, {3, 7}}), "");
  EXPECT_NE(fault(QuestionKind::rays, {{2, 5}}), "");
}

constexpr std::string_view kResults = R"({
  "context": {"cpu": "some", "cores": "2", "compiler": "GCC", "commit": "abc"},
  "benchmarks": [
    {"run_name": "queries/uniform/10000/boxes/stream/iterations:1/manual_time", "run_type": "aggregate",
     "aggregate_name": "median", "real_time": 100, "p99": 150},
    {"run_name": "queries/uniform/10000/boxes/stream_batch/iterations:1/manual_time", "run_type": "aggregate",
     "aggregate_name": "median", "real_time": 10},
    {"run_name": "queries/uniform/10000/boxes/bullet/iterations:1/manual_time", "run_type": "aggregate",
     "aggregate_name": "median", "real_time": 400, "p99": NaN},
    {"run_name": "queries/uniform/10000/boxes/embree/iterations:1/manual_time", "run_type": "aggregate",
     "aggregate_name": "median", "real_time": 50, "error_occurred": true},
    {"run_name": "queries/varied/10000/boxes/stream/iterations:1/manual_time", "run_type": "aggregate",
     "aggregate_name": "median", "real_time": 100},
    {"run_name": "queries/varied/10000/boxes/fcl/iterations:1/manual_time", "run_type": "aggregate",
     "aggregate_name": "median", "real_time": 900},
    {"run_name": "moved/varied/10000/boxes/fcl/iterations:1/manual_time", "run_type": "iteration",
     "real_time": 900, "move": 3.25},
    {"run_name": "frames/varied/10000/rays/1/stream/iterations:1/manual_time", "run_type": "aggregate",
     "aggregate_name": "median", "time_unit": "us", "real_time": 200, "ask": 190},
    {"run_name": "frames/varied/10000/rays/1/embree/iterations:1/manual_time", "run_type": "aggregate",
     "aggregate_name": "median", "time_unit": "us", "real_time": 700, "ask": 180}]})";

TEST(QueryTables, SayHowFarTheBestOfTheOthersIsBehindAndLeaveErrorsOut) {
  QueryResults results;
  ASSERT_TRUE(add_query_results(kResults, results).ok());
  const auto ratios = query_ratios(results);
  ASSERT_EQ(ratios.size(), 2U);
  EXPECT_EQ(ratios[0].best, "bullet");
  EXPECT_DOUBLE_EQ(ratios[0].ratio(), 4);
  EXPECT_NE(query_summary(results).find("| boxes, 4 found | **6.0**; 4.0 (uniform, `bullet`) |"),
            std::string::npos)
      << query_summary(results);
  EXPECT_NE(query_cells(results).find("| uniform | 10,000 | boxes, 4 found | 100 | 150 |  | 10 | `bullet`"),
            std::string::npos)
      << query_cells(results);
  EXPECT_NE(moved_cells(results).find("| `fcl` | 3.2 | 900 |"), std::string::npos) << moved_cells(results);
  EXPECT_NE(frame_cells(results).find("| varied | 10,000 | 1 % | 200 | 190 | `embree` **3.5**; 180 |"),
            std::string::npos)
      << frame_cells(results);
  EXPECT_FALSE(add_query_results("[]", results).ok());
}

}  // namespace
}  // namespace cellsweep::bench
