#include "report/run_json.h"

#include <gtest/gtest.h>

namespace cellsweep::report {
namespace {

TEST(RunJson, HasTheDocumentedShape) {
  RunReport run;
  run.engine = "control";
  run.bodies = 7;
  run.initial_ms = 1.5;
  run.setup_ms = 0.25;
  run.update_ms = {3, 1, 2};
  run.frames = {{0, 12, 0xabcULL}};
  const std::vector<RunReport> runs = {run};
  EXPECT_EQ(to_json(runs).dump(),
            R"({"engines":[{"engine":"control","bodies":7,"frames":3,"initial_ms":1.5,"setup_ms":0.25,)"
            R"("update_ms":{"median":2.0,"p99":3.0,"max":3.0},)"
            R"("reports":[{"frame":0,"pairs":12,"hash":"0000000000000abc"}]}]})");
}

TEST(RunJson, SaysWhetherAllEnginesAreExact) {
  VerifyReport good;
  good.engine = "good";
  VerifyReport bad;
  bad.engine = "bad";
  bad.missed = 1;
  bad.first = Difference{4, {1, 2}, true, {}, {}};
  const std::vector<VerifyReport> all_good = {good};
  const std::vector<VerifyReport> one_bad = {good, bad};
  EXPECT_TRUE(to_json(all_good)["exact"]);
  const auto json = to_json(one_bad);
  EXPECT_FALSE(json["exact"]);
  EXPECT_FALSE(json["engines"][0].contains("first_difference"));
  EXPECT_EQ(json["engines"][1]["first_difference"]["frame"], 4);
  EXPECT_EQ(json["engines"][1]["first_difference"]["kind"], "missed");
}

}  // namespace
}  // namespace cellsweep::report
