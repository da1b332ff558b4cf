/// @file
/// `cellsweep query`: what it prints of a world of a few bodies, and that its answers are those of looking at
/// each box.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/text.h"
#include "cellsweep/engines.h"
#include "cellsweep/world/recording.h"
#include "cellsweep/world/scene.h"
#include "cellsweep/world/trace.h"
#include "command_line.h"
#include "project_file.h"
#include "queries/reference.h"

namespace cellsweep::app {
namespace {

using queries::Reference;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using OrderedJson = nlohmann::ordered_json;

constexpr Aabb unit_cube(float x) {
  return {{x, 0, 0}, {x + 1, 1, 1}};
}

/// Unit cubes at x 0, 3 and 5; in frame 1 body 1 is at 4, and touches body 2.
class QueryCommand : public testing::Test {
 protected:
  QueryCommand() {
    const Recording recording{"three",
                              "",
                              {{0, 0, 0}, {6, 1, 1}},
                              3,
                              {unit_cube(0), unit_cube(3), unit_cube(5),  //
                               unit_cube(0), unit_cube(4), unit_cube(5)}};
    EXPECT_TRUE(write_recording(recording, scratch_.path("three.npy")).ok());
  }

  CommandResult ask(const std::string& questions) const {
    return run_command(text("query ", scratch_.path("three.npy"), " ", questions));
  }

  /// What follows on the table of the world.
  std::string answer(const std::string& questions) const {
    const CommandResult result = ask(questions);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return result.output.substr(std::min(result.output.find("\n\n"), result.output.size()));
  }

  OrderedJson answers(const std::string& questions) const {
    const CommandResult result = ask("--json " + questions);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return OrderedJson::parse(result.output)["answers"];
  }

  std::string write(const std::string& name, const std::string& content) const {
    std::ofstream(scratch_.path(name)) << content;
    return scratch_.path(name);
  }

  ScratchFolder scratch_;
};

TEST_F(QueryCommand, PrintsAnswersAsTablesForAPerson) {
  const CommandResult result = ask("--box 0,0,0,3,1,1 --ray -2,0.5,0.5,4,0,0");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.errors, IsEmpty());
  EXPECT_EQ(result.output,
            "source  engine  frame  bodies\n"
            "------  ------  -----  ------\n"
            "three   stream      0       3\n"
            "\n"
            "--box 0,0,0,3,1,1: 2 bodies\n"
            "0 1\n"
            "\n"
            "--ray -2,0.5,0.5,4,0,0: 3 bodies\n"
            "body  time\n"
            "----  ----\n"
            "   0   0.5\n"
            "   1  1.25\n"
            "   2  1.75\n");
}

TEST_F(QueryCommand, AnswersEachFormOfQuestion) {
  EXPECT_EQ(answer("--point 1,1,1"), "\n\n--point 1,1,1: 1 body\n0\n");
  EXPECT_EQ(answer("--sphere 2,0.5,0.5,0.5"), "\n\n--sphere 2,0.5,0.5,0.5: no body\n");
  EXPECT_EQ(answer("--sphere 2,0.5,0.5,1"), "\n\n--sphere 2,0.5,0.5,1: 2 bodies\n0 1\n");
  EXPECT_EQ(answer("--segment 2,1,1,6,1,1"),
            "\n\n--segment 2,1,1,6,1,1: 2 bodies\nbody  time\n----  ----\n   1  0.25\n   2  0.75\n");
  EXPECT_EQ(answer("--sweep 1.5,0,0,2,1,1,4,0,0"),
            "\n\n--sweep 1.5,0,0,2,1,1,4,0,0: 2 bodies\n"
            "body  time\n----  ----\n   1  0.25\n   2  0.75\n");
  EXPECT_EQ(answer("--nearest 2.5,0,0 --count 2"),
            "\n\n--nearest 2.5,0,0 --count 2: 2 bodies\n"
            "body  distance\n----  --------\n   1       0.5\n   0       1.5\n");
  EXPECT_EQ(answer("--within 7,0,0,8,1,1 --distance 3"),
            "\n\n--within 7,0,0,8,1,1 --distance 3: 2 bodies\n"
            "body  distance\n----  --------\n   2         1\n   1         3\n");
  EXPECT_EQ(answer("--frame 1 --pairs-of 2,0"),
            "\n\n--pairs-of 2,0: 1 pair\nbody  with\n----  ----\n   1     2\n");
}

TEST_F(QueryCommand, DetailsChangeTheQuestionsThatHaveThem) {
  EXPECT_EQ(answer("--ray -2,1,1,4,0,0 --end 1.5 --point 9,9,9"),
            "\n\n--ray -2,1,1,4,0,0 --end 1.5: 2 bodies\nbody  time\n----  ----\n   0   0.5\n   1  1.25\n"
            "\n--point 9,9,9: no body\n");
  EXPECT_EQ(answer("--ray 2,1,1,1,0,0 --first"),
            "\n\n--ray 2,1,1,1,0,0 --first: 1 body\nbody  time\n----  ----\n   1     1\n");
  EXPECT_EQ(answer("--ray 2,1,1,0,1,0 --first"), "\n\n--ray 2,1,1,0,1,0 --first: no body\n");
  EXPECT_EQ(answer("--box 1.5,0,0,2,1,1 --segment 1,0,0,0,0,0 --any"),
            "\n\n--box 1.5,0,0,2,1,1 --any: no\n\n--segment 1,0,0,0,0,0 --any: yes\n");
  EXPECT_EQ(
      answer("--nearest 2.5,0,0 --count 3 --most 1"),
      "\n\n--nearest 2.5,0,0 --count 3 --most 1: 1 body\nbody  distance\n----  --------\n   1       0.5\n");
}

TEST_F(QueryCommand, AnswersInTheOrderOfTheCommandLineThoseOfAFileLast) {
  const std::string file = write("questions.jsonl", "{\"nearest\": [9, 0, 0]}\n\n{\"point\": [0, 0, 0]}");
  const OrderedJson all = answers("--questions " + file + " --point 5,0,0 --box 0,0,0,9,9,9 --point 3,0,0");
  ASSERT_EQ(all.size(), 5U);
  EXPECT_EQ(all[0],
            OrderedJson::parse(R"({"question": {"point": [5.0, 0.0, 0.0]}, "count": 1, "bodies": [2]})"));
  EXPECT_EQ(all[1]["bodies"], OrderedJson::array({0, 1, 2}));
  EXPECT_EQ(all[2]["bodies"], OrderedJson::array({1}));
  EXPECT_EQ(all[3]["neighbors"], OrderedJson::parse(R"([{"body": 2, "distance": 3.0}])"));
  EXPECT_EQ(all[4]["bodies"], OrderedJson::array({0}));
}

TEST_F(QueryCommand, PrintsOneJsonObject) {
  const CommandResult result =
      ask("--json --frame 1 --ray 2,1,1,1,0,0 --first --pairs-of 1 --engine control --point 9,9,9");
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(OrderedJson::parse(result.output), OrderedJson::parse(R"({
    "source": "three", "engine": "control", "frame": 1, "bodies": 3,
    "answers": [
      {"question": {"ray": [2.0, 1.0, 1.0, 1.0, 0.0, 0.0], "first": true}, "count": 1,
       "touches": [{"body": 1, "time": 2.0}]},
      {"question": {"pairs_of": [1]}, "count": 1, "pairs": [[1, 2]]},
      {"question": {"point": [9.0, 9.0, 9.0]}, "count": 0, "bodies": []}]})"));
}

TEST_F(QueryCommand, TakesTheQuestionsOfItsAnswersBack) {
  const std::string typed =
      "--box 0,0,0,3,1,1 --ray -2,0.1,0.5,4,0,0 --end 1.5 --nearest 1e-3,0,0 --count 2 --most 7 "
      "--within 7,0,0 --distance 3 --pairs-of 1,2 --sphere 0,0,0,1e300 --as-mask 0xff";
  const OrderedJson all = answers(typed);
  std::string lines;
  for (const OrderedJson& one : all) lines += one["question"].dump() + "\n";
  EXPECT_EQ(answers("--questions " + write("again.jsonl", lines)), all);
}

TEST_F(QueryCommand, ReadsQuestionsFromStandardInput) {
  const std::string input = write("input.jsonl", "{\"box\": [0, 0, 0, 9, 9, 9], \"any\": true}\r\n");
  const CommandResult result =
      run_command("query --json --questions - " + scratch_.path("three.npy"), "", input);
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(OrderedJson::parse(result.output)["answers"][0]["any"], true);
}

TEST_F(QueryCommand, AnswersThoseThatABodyWithAFilterMayMeet) {
  if (!traces_have_files()) GTEST_SKIP() << "a build without libzip";
  Trace trace;
  trace.inserted = {3, 4, 8};
  trace.inserted_boxes = {unit_cube(0), unit_cube(0), unit_cube(0)};
  trace.inserted_filters = {{1, 7, true}, {2, 7, false}, {4, 2, false}};
  trace.inserted_ends = {3};
  trace.removed_ends = trace.moved_ends = {0};
  const std::string file = scratch_.path("filters.npz");
  ASSERT_TRUE(write_trace(trace, file).ok());
  const auto bodies = [&](const std::string& filter) {
    const CommandResult result = run_command("query --json --point 0,0,0 " + file + " " + filter);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return OrderedJson::parse(result.output)["answers"][0]["bodies"];
  };
  EXPECT_EQ(bodies(""), OrderedJson::array({3, 4, 8}));
  EXPECT_EQ(bodies("--as-mask 0x6"), OrderedJson::array({4}));
  EXPECT_EQ(bodies("--as-mask 6 --as-category 2"), OrderedJson::array({4, 8}));
  EXPECT_EQ(bodies("--as-static"), OrderedJson::array({4}));
  const std::string own =
      write("own.jsonl", R"({"point": [0, 0, 0], "as": {"category": 2, "static": true}})");
  const CommandResult result = run_command("query --json --as-mask 1 " + file + " --questions " + own);
  EXPECT_EQ(OrderedJson::parse(result.output)["answers"][0]["bodies"], OrderedJson::array({4, 8}))
      << "a line's own filter";
}

OrderedJson touches_json(const std::vector<Touch>& touches) {
  OrderedJson list = OrderedJson::array();
  for (const Touch& touch : touches) list.push_back({{"body", touch.body}, {"time", touch.time}});
  return list;
}

OrderedJson neighbors_json(const std::vector<Neighbor>& neighbors) {
  OrderedJson list = OrderedJson::array();
  for (const Neighbor& one : neighbors) list.push_back({{"body", one.body}, {"distance", one.distance}});
  return list;
}

OrderedJson pairs_json(const std::vector<Pair>& pairs) {
  OrderedJson list = OrderedJson::array();
  for (const Pair& pair : pairs) list.push_back({pair.a, pair.b});
  return list;
}

/// The boxes of a scene at a frame.
Reference boxes_of(const SceneSettings& settings, std::size_t frame) {
  const auto source = make_scene_frames(settings);
  EXPECT_TRUE(source.ok());
  for (std::size_t at = 0; at < frame; ++at) EXPECT_TRUE((*source)->advance());
  Reference boxes;
  for (const BodyId body : (*source)->bodies()) boxes.boxes[body] = (*source)->boxes()[body];
  return boxes;
}

TEST(QueryCommandOnAScene, EqualsLookingAtEachBoxOnEveryEngine) {
  SceneSettings settings;
  settings.scene = "open-world";
  settings.bodies = 800;
  const Reference reference = boxes_of(settings, 12);
  const Aabb middle = reference.boxes.begin()->second;
  const std::string at = text(middle.min[0], ",", middle.min[1], ",", middle.min[2]);
  const Region sphere(middle.min, 20);
  const Ray ray{middle.min, {-1, 0.25, 0.5}};
  const std::vector<BodyId> ends = {reference.boxes.begin()->first,
                                    std::next(reference.boxes.begin(), 70)->first};
  ASSERT_FALSE(reference.pairs_of(ends).empty());
  const std::string questions =
      text("--sphere ", at, ",20 --ray ", at, ",-1,0.25,0.5 --nearest ", at, " --count 9 --within ", at,
           " --distance 20 --pairs-of ", ends[0], ",", ends[1]);
  ASSERT_GT(reference.overlaps(sphere).size(), 1U);
  for (const EngineInfo& engine : engine_table()) {
    const CommandResult result = run_command(text(
        "query --json --scene open-world --bodies 800 --frame 12 --engine ", engine.name, " ", questions));
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    const OrderedJson all = OrderedJson::parse(result.output)["answers"];
    EXPECT_EQ(all[0]["bodies"], OrderedJson(reference.overlaps(sphere))) << engine.name;
    EXPECT_EQ(all[1]["touches"], touches_json(reference.touches(ray))) << engine.name;
    EXPECT_EQ(all[2]["neighbors"],
              neighbors_json(reference.nearest(box_at(middle.min), 9, Queries::kAnyDistance)))
        << engine.name;
    EXPECT_EQ(all[3]["neighbors"], neighbors_json(reference.within(sphere))) << engine.name;
    EXPECT_EQ(all[4]["pairs"], pairs_json(reference.pairs_of(ends))) << engine.name;
  }
}

struct RefusedQuestion {
  std::string name;
  std::string arguments;
  std::string says;
};

void PrintTo(const RefusedQuestion& refused, std::ostream* stream) {
  *stream << refused.arguments;
}

class RefusedQuery : public testing::TestWithParam<RefusedQuestion> {};

TEST_P(RefusedQuery, ExitsWithTwoAndSaysWhyOnStandardErrorOnly) {
  const CommandResult result = run_command("query --bodies 9 " + GetParam().arguments);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr(GetParam().says));
  EXPECT_THAT(result.output, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    All, RefusedQuery,
    testing::Values(
        RefusedQuestion{"Nothing", "", "Nothing is asked; questions are --box, --point, "},
        RefusedQuestion{"TooFewNumbers", "--box 0,0,0,1,1", "--box: 6 numbers, MINX,MINY,"},
        RefusedQuestion{"TooManyNumbers", "--point 0,0,0,1",
                        "--point: 3 numbers, X,Y,Z, are wanted, and there are 4."},
        RefusedQuestion{"NeitherPointNorBox", "--nearest 0,0,0,1", "--nearest: 3 or 6 numbers are wanted"},
        RefusedQuestion{"NoNumber", "--ray 0,0,x,1,1,1", "--ray: \"x\" is no number."},
        RefusedQuestion{"AnEmptyNumber", "--point 0,,0", "--point: \"\" is no number."},
        RefusedQuestion{"NumberBeyondNumbers", "--point 0,0,1e999", "--point: \"1e999\" is out of range."},
        RefusedQuestion{"CoordinateBeyondFloats", "--segment 0,0,0,0,0,-1e39",
                        "a coordinate is -1e+39; it must be finite, and is at most 3.4028"},
        RefusedQuestion{"NoCoordinate", "--point 0,nan,0", "--point: a coordinate is nan"},
        RefusedQuestion{"AnInsideOutBox", "--box 0,2,0,1,1,1",
                        "--box 0,2,0,1,1,1: The box is refused: on axis y it goes from 2 to 1"},
        RefusedQuestion{"ANegativeRadius", "--sphere 0,0,0,-1", "--sphere 0,0,0,-1: "},
        RefusedQuestion{"ARayToNowhere", "--ray 0,0,0,0,0,0",
                        "--ray 0,0,0,0,0,0: The direction is (0, 0, 0)"},
        RefusedQuestion{"ANegativeEnd", "--ray 0,0,0,1,0,0 --end -1", "--end: a number, 0 or more"},
        RefusedQuestion{"AnEndOfNoPath", "--point 0,0,0 --end 1",
                        "--end is of no question on this command line"},
        RefusedQuestion{"TheFirstOfARegion", "--point 0,0,0 --first", "--first is of no question"},
        RefusedQuestion{"FirstAndAny", "--ray 0,0,0,1,0,0 --first --any", "--first excludes --any"},
        RefusedQuestion{"NearestNone", "--nearest 0,0,0 --count 0", "--count: a whole number, 1 or more"},
        RefusedQuestion{"WithinNoDistance", "--within 0,0,0", "--within: it needs --distance."},
        RefusedQuestion{"HalfAnId", "--pairs-of 1,1.5",
                        "--pairs-of: a body's id is 1.5; it must be a whole number, 0 to 4,294,967,295."},
        RefusedQuestion{"AnUnknownBody", "--pairs-of 8,9", "--pairs-of 8,9: Body 9 is unknown"},
        RefusedQuestion{
            "BitsThatAreNone", "--point 0,0,0 --as-mask 0x1ffffffff",
            "--as-mask: bits are wanted, 0 to 4,294,967,295 or 0x0 to 0xffffffff, not \"0x1ffffffff\""},
        RefusedQuestion{"ManyEngines", "--point 0,0,0 --engine stream,oracle", "one engine at a time"},
        RefusedQuestion{"NoSuchFile", "--questions /no/such.jsonl", "/no/such.jsonl"},
        RefusedQuestion{"EmptyStandardInput", "--questions -", "Nothing is asked"}),
    [](const auto& refused) { return refused.param.name; });

TEST(RefusedQueryOfAFrame, NamesTheLastFrameThatThereIs) {
  const CommandResult result = run_command("query " + project_file("bench/scenes/bullet-pile-1024.aabbs") +
                                           " --frame 31 --point 0,0,0");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("Frame 31 was asked for, but the last frame is 30."));
}

TEST(RefusedQueryOfAWorld, ThatIsTooLargeExitsWithThree) {
  EXPECT_EQ(run_command("query --point 0,0,0 --bodies 5000 --engine control").exit_code, 3);
}

class RefusedLine : public testing::TestWithParam<RefusedQuestion> {};

TEST_P(RefusedLine, IsNamedByItsNumber) {
  const ScratchFolder scratch;
  const std::string file = scratch.path("q.jsonl");
  std::ofstream(file) << "{\"point\": [0, 0, 0]}\n" << GetParam().arguments << "\n";
  const CommandResult result = run_command("query --bodies 9 --questions " + file);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr(file + ", line 2" + GetParam().says));
  EXPECT_THAT(result.output, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    All, RefusedLine,
    testing::Values(
        RefusedQuestion{"NoJson", "{\"point\": [0, 0",
                        ": a JSON object is wanted, such as {\"point\": [0, 0, 0]}."},
        RefusedQuestion{"NoObject", "[1, 2, 3]", ": a JSON object is wanted"},
        RefusedQuestion{"NoQuestion", "{\"end\": 1}", ": it asks nothing; there are: box, point, "},
        RefusedQuestion{"TwoQuestions", R"({"box": [0,0,0,1,1,1], "point": [0,0,0]})",
                        ": it asks for box and for point"},
        RefusedQuestion{"ASlip", R"({"boxx": [0,0,0,1,1,1]})", ": there is no \"boxx\"; did you mean box?"},
        RefusedQuestion{"NoList", R"({"point": 7})", ": point is a list of numbers, not 7."},
        RefusedQuestion{"NoNumbers", R"({"point": [0, 0, "a"]})",
                        ": point is a list of numbers, not [0,0,\"a\"]."},
        RefusedQuestion{"TooFewNumbers", R"({"sweep": [0,0,0,1,1,1]})", ", sweep: 9 numbers, "},
        RefusedQuestion{"NumberBeyondNumbers", R"({"point": [0,0,1e999]})", ": a JSON object is wanted"},
        RefusedQuestion{"CoordinateBeyondFloats", R"({"point": [0,0,1e99]})",
                        ", point: a coordinate is 1e+99"},
        RefusedQuestion{"ANegativeEnd", R"({"ray": [0,0,0,1,0,0], "end": -1})",
                        ": end is a number, 0 or more, not -1."},
        RefusedQuestion{"AnEndOfNoPath", R"({"point": [0,0,0], "end": 1})", ", point: it has no end."},
        RefusedQuestion{"FirstAndAny", R"({"ray": [0,0,0,1,0,0], "first": true, "any": true})",
                        ", ray: first and any are not for one question."},
        RefusedQuestion{"NoTruth", R"({"point": [0,0,0], "any": 1})", ": any is true or false, not 1."},
        RefusedQuestion{"HalfACount", R"({"nearest": [0,0,0], "count": 1.5})",
                        ": count is a whole number, 1 or more, not 1.5."},
        RefusedQuestion{"WithinNoDistance", R"({"within": [0,0,0]})", ", within: it needs distance."},
        RefusedQuestion{"NoIds", R"({"pairs_of": []})", ", pairs_of: at least one id is wanted."},
        RefusedQuestion{"NoFilter", R"({"point": [0,0,0], "as": 3})",
                        ": as is an object, such as {\"mask\": 2}, not 3."},
        RefusedQuestion{"FilterWithASlip", R"({"point": [0,0,0], "as": {"maks": 1}})",
                        ": as has category, mask and static, not \"maks\"."},
        RefusedQuestion{"BitsThatAreNone", R"({"point": [0,0,0], "as": {"mask": 4294967296}})",
                        ": mask is a whole number, 0 to 4,294,967,295, not 4294967296."}),
    [](const auto& refused) { return refused.param.name; });

}  // namespace
}  // namespace cellsweep::app
