#include "report/experiment/standing.h"

#include "base/text.h"
#include "report/units.h"

namespace cellsweep::report {
namespace {

constexpr std::string_view kStream = "stream";
constexpr std::string_view kYardstick = "control";

/// An engine's time.
struct Time {
  std::string_view engine;
  double microseconds = 0;
};

// Of the others, over whole frames; nothing when there are none.
std::optional<Time> fastest_other(const ExperimentResults& results, std::size_t bodies, Measure measure) {
  std::optional<Time> fastest;
  for (const CurveResult& result : results.curves) {
    if (result.curve.part != Part::frame || result.curve.engine == kStream) continue;
    const auto point = result.points.find(bodies);
    if (point == result.points.end()) continue;
    const double time = point->second[measure].median;
    if (!fastest || time < fastest->microseconds) fastest = Time{result.curve.engine, time};
  }
  return fastest;
}

// "stream is 9.41 times as fast".
std::string comparison(double stream, double other) {
  const bool faster = stream <= other;
  return text("stream is ", factor_text(faster ? other / stream : stream / other), " times as ",
              faster ? "fast" : "slow");
}

}  // namespace

std::string standing_text(const ExperimentResults& results, Measure measure) {
  for (auto bodies = results.settings.bodies.rbegin(); bodies != results.settings.bodies.rend(); ++bodies) {
    const auto stream = results.at(kStream, *bodies, measure);
    const auto other = fastest_other(results, *bodies, measure);
    if (!stream || !other || *stream <= 0) continue;
    std::string words =
        text("With ", count_text(*bodies), " boxes stream takes ", time_text(*stream),
             ". The fastest of the others is ", other->engine, " with ", time_text(other->microseconds), ": ",
             comparison(*stream, other->microseconds), ".");
    const auto control = results.at(kYardstick, *bodies, measure);
    if (!control || other->engine == kYardstick) return words;
    return words +
           text(" ", kYardstick, " takes ", time_text(*control), ": ", comparison(*stream, *control), ".");
  }
  return {};
}

}  // namespace cellsweep::report
