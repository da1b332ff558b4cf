#include "report/run_json.h"

#include <algorithm>

#include "report/quantile.h"

namespace cellsweep::report {
namespace {

using Json = nlohmann::ordered_json;

Json frame_json(const FrameReport& frame) {
  return {{"frame", frame.frame}, {"pairs", frame.pairs}, {"hash", hash_text(frame.hash)}};
}

Json run_json(const RunReport& run) {
  Json frames = Json::array();
  for (const FrameReport& frame : run.frames) frames.push_back(frame_json(frame));
  return {{"engine", run.engine},
          {"bodies", run.bodies},
          {"frames", run.update_ms.size()},
          {"initial_ms", run.initial_ms},
          {"setup_ms", run.setup_ms},
          {"update_ms",
           {{"median", quantile(run.update_ms, 0.5)},
            {"p99", quantile(run.update_ms, 0.99)},
            {"max", quantile(run.update_ms, 1.0)}}},
          {"reports", frames}};
}

Json difference_json(const Difference& difference) {
  return {{"frame", difference.frame},
          {"a", difference.pair.a},
          {"b", difference.pair.b},
          {"kind", difference.missed ? "missed" : "invented"},
          {"box_a", {difference.box_a.min, difference.box_a.max}},
          {"box_b", {difference.box_b.min, difference.box_b.max}}};
}

Json verdict_json(const VerifyReport& verdict) {
  Json json = {{"engine", verdict.engine}, {"exact", verdict.exact()}, {"frames", verdict.frames},
               {"pairs", verdict.pairs},   {"missed", verdict.missed}, {"invented", verdict.invented}};
  if (verdict.first) json["first_difference"] = difference_json(*verdict.first);
  return json;
}

}  // namespace

Json to_json(std::span<const RunReport> runs) {
  Json engines = Json::array();
  for (const RunReport& run : runs) engines.push_back(run_json(run));
  return {{"engines", engines}};
}

Json to_json(std::span<const VerifyReport> verdicts) {
  Json engines = Json::array();
  for (const VerifyReport& verdict : verdicts) engines.push_back(verdict_json(verdict));
  const bool exact =
      std::all_of(verdicts.begin(), verdicts.end(), [](const VerifyReport& v) { return v.exact(); });
  return {{"exact", exact}, {"engines", engines}};
}

}  // namespace cellsweep::report
