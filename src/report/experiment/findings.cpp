#include "report/experiment/findings.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/text.h"
#include "report/units.h"

namespace cellsweep::report {
namespace {

// "Quite similar" (5.3), in numbers.
constexpr double kSimilar = 1.5;
constexpr std::size_t kFlatFrom = 64;
constexpr std::size_t kFlatTo = 512;
constexpr std::size_t kRuined = 1024;
constexpr double kInteractive = 1e6 / 30;  // microseconds of a frame at 30 a second

/// Two curves at one size.
struct Race {
  std::size_t bodies = 0;
  double cell = 0;
  double x86 = 0;

  double factor() const { return x86 / cell; }
};

std::vector<Race> races(const ExperimentResults& results, std::string_view cell, Measure measure) {
  std::vector<Race> all;
  for (const std::size_t bodies : results.settings.bodies) {
    const auto time = results.at(cell, bodies, measure);
    const auto x86 = results.at("control", bodies, measure);
    if (time && x86) all.push_back({bodies, *time, *x86});
  }
  return all;
}

Verdict verdict_of(bool holds) {
  return holds ? Verdict::holds : Verdict::fails;
}

Finding unknown(Finding finding, const std::string& missing) {
  finding.verdict = Verdict::unknown;
  finding.text = "Not measured: " + missing + ".";
  return finding;
}

// "With 64 boxes cell-paper takes 335 µs and control 406 µs (1.21 times as fast)".
std::string race_text(const Race& race, const std::string& name) {
  const bool faster = race.factor() >= 1;
  return text("With ", count_text(race.bodies), race.bodies == 1 ? " box " : " boxes ", name, " takes ",
              time_text(race.cell), " and control ", time_text(race.x86), ": ",
              factor_text(faster ? race.factor() : 1 / race.factor()),
              faster ? " times as fast" : " times as slow");
}

double sum_of(const std::vector<Step>& steps) {
  double sum = 0;
  for (const Step& step : steps) sum += step.microseconds;
  return sum;
}

// "Of such a frame 62 % is "update pairs" and 31 % "spus"." Empty when nothing is known.
std::string steps_text(const std::map<std::pair<std::string, std::size_t>, std::vector<Step>>& all,
                       const std::string& engine, std::size_t bodies) {
  const auto found = all.find({engine, bodies});
  if (found == all.end() || sum_of(found->second) <= 0) return {};
  std::vector<Step> steps = found->second;
  const double sum = sum_of(steps);
  std::stable_sort(steps.begin(), steps.end(),
                   [](const Step& one, const Step& other) { return one.microseconds > other.microseconds; });
  const auto share = [&](const Step& step) {
    return text(std::lround(100 * step.microseconds / sum), " % are step “", step.name, "”");
  };
  std::string result = text(" Of ", engine, "'s frame with ", count_text(bodies), " boxes ", share(steps[0]));
  if (steps.size() > 1) result += " and " + share(steps[1]);
  return result + ".";
}

std::string resident_text(const ExperimentResults& results, std::size_t bodies, Measure measure) {
  const auto resident = results.at("cell-resident", bodies, measure);
  if (!resident) return {};
  return text(" cell-resident, the document's own future work, takes ", time_text(*resident), ".");
}

// " A simulated Cell's SPEs take 10 ms with 64 boxes and 20 ms with 512." Empty when that was not simulated.
std::string simulated_text(const ExperimentResults& results, std::size_t from, std::size_t to,
                           Measure measure) {
  const auto first = results.at("cell-paper-simulated", from, measure);
  const auto last = results.at("cell-paper-simulated", to, measure);
  if (!first || !last) return {};
  return text(" The SPEs of a simulated Cell take ", time_text(*first), " with ", count_text(from),
              " boxes and ", time_text(*last), " with ", count_text(to), ".");
}

Finding judge_initial(const ExperimentResults& results) {
  Finding finding{"initial", "The Cell version wins the initial sort, and by more the more boxes there are",
                  "5.1", Verdict::unknown, ""};
  const std::vector<Race> all = races(results, "cell-paper", Measure::initial);
  if (all.size() < 2) return unknown(finding, "cell-paper and control at two sizes");
  const Race& first = all.front();
  const Race& last = all.back();
  finding.verdict = verdict_of(last.factor() > 1 && last.factor() > first.factor());
  finding.text = text(
      race_text(last, "cell-paper"), "; with ", count_text(first.bodies), " boxes the factor is ",
      factor_text(first.factor()), ". The lead ", last.factor() > first.factor() ? "grows" : "does not grow",
      " with the number of boxes.", steps_text(results.initial_steps, "cell-paper", last.bodies),
      resident_text(results, last.bodies, Measure::initial),
      simulated_text(results, first.bodies, last.bodies, Measure::initial));
  return finding;
}

Finding judge_static(const ExperimentResults& results) {
  Finding finding{"static", "The Cell version loses to the x86 version when nothing moves", "5.2",
                  Verdict::unknown, ""};
  const std::vector<Race> all = races(results, "cell-paper", Measure::still);
  if (all.empty()) return unknown(finding, "cell-paper and control at one size");
  const auto lost =
      std::count_if(all.begin(), all.end(), [](const Race& race) { return race.cell > race.x86; });
  finding.verdict = verdict_of(static_cast<std::size_t>(lost) == all.size());
  finding.text = text("cell-paper loses at ", lost, " of ", all.size(), " sizes. ",
                      race_text(all.front(), "cell-paper"), "; with ", count_text(all.back().bodies),
                      " boxes it is ", time_text(all.back().cell), " and ", time_text(all.back().x86), ".");
  if (finding.verdict == Verdict::holds) {
    finding.text += text(
        " Its sorted lists have nothing to do either, but it starts three SPU threads and waits for them in "
        "every frame: where the document had a floor of about 3 ms, there are ",
        time_text(all.front().cell), " here.");
  }
  finding.text += resident_text(results, all.back().bodies, Measure::still);
  return finding;
}

Finding judge_spus(const ExperimentResults& results) {
  Finding finding{
      "dynamic-spus",
      "Without the pair manager's updates, the Cell version gets ahead of the x86 version as boxes are added",
      "5.3", Verdict::unknown, ""};
  const std::vector<Race> all = races(results, "cell-paper-spus", Measure::longest);
  if (all.empty()) return unknown(finding, "the SPU part of cell-paper and control at one size");
  const Race& last = all.back();
  finding.verdict = verdict_of(last.factor() > 1);
  finding.text = race_text(last, "the SPU part of cell-paper") + " in the longest frame.";
  const auto alone = results.at("cell-paper-longest-spu", last.bodies, Measure::longest);
  if (alone) {
    finding.text += text(
        " Counting only the processor time of the SPU that worked longest, as if each had a core of its "
        "own and threads started by themselves, it is ",
        time_text(*alone), ", ", *alone < last.x86 ? "less" : "more", " than control's.");
  }
  if (finding.verdict == Verdict::fails) {
    finding.text +=
        " A scalar insertion sort suits a core of today better than the document's PC, and the SPUs' "
        "vectors are emulated.";
  }
  return finding;
}

Finding judge_flat(const ExperimentResults& results) {
  Finding finding{"dynamic-spus",
                  "The Cell version's longest frame takes about as long with 512 boxes as with 64", "5.3",
                  Verdict::unknown, ""};
  const auto small = results.at("cell-paper-spus", kFlatFrom, Measure::longest);
  const auto large = results.at("cell-paper-spus", kFlatTo, Measure::longest);
  if (!small || !large) return unknown(finding, "the SPU part of cell-paper with 64 and with 512 boxes");
  const double growth = *large / *small;
  finding.verdict = verdict_of(growth <= kSimilar && growth >= 1 / kSimilar);
  finding.text = text("From 64 to 512 boxes its longest time goes from ", time_text(*small), " to ",
                      time_text(*large), ", a factor of ", factor_text(growth), "; up to ",
                      factor_text(kSimilar), " is called similar here.");
  const auto x86_small = results.at("control", kFlatFrom, Measure::longest);
  const auto x86_large = results.at("control", kFlatTo, Measure::longest);
  if (x86_small && x86_large) {
    finding.text += text(" control's grows by a factor of ", factor_text(*x86_large / *x86_small), ".");
  }
  finding.text +=
      text(" In the document a floor of 3 ms, for starting threads, hid the work; ",
           finding.verdict == Verdict::holds ? "here it stays hidden, too." : "here the work shows.");
  finding.text += simulated_text(results, kFlatFrom, kFlatTo, Measure::longest);
  if (results.at("cell-paper-simulated", kFlatTo, Measure::longest)) {
    finding.text += " Starting their threads, the document's floor, would come on top.";
  }
  return finding;
}

Finding judge_updates(const ExperimentResults& results) {
  Finding finding{
      "dynamic",
      "Updating the pair manager costs time: bearable up to 512 boxes, with 1,024 it ruins the frame", "5.3",
      Verdict::unknown, ""};
  const auto at = [&](std::string_view curve, Measure measure) {
    return results.at(curve, kRuined, measure);
  };
  const auto whole = at("cell-paper", Measure::longest);
  const auto spus = at("cell-paper-spus", Measure::longest);
  const auto usual = at("cell-paper", Measure::median);
  const auto usual_spus = at("cell-paper-spus", Measure::median);
  const auto x86 = at("control", Measure::longest);
  if (!whole || !spus || !usual || !usual_spus || !x86) {
    return unknown(finding, "cell-paper, its SPU part and control with 1,024 boxes");
  }
  const double updates = 1 - *usual_spus / *usual;
  finding.verdict = verdict_of(updates > 0.5 && *whole > *x86);
  finding.text = text(
      "With 1,024 boxes the longest frame is ", time_text(*whole), " with updates, ", time_text(*spus),
      " without, and ", time_text(*x86), " of control; it is ", *whole > kInteractive ? "not" : "still",
      " within the ", time_text(kInteractive), " of 30 frames a second. Of the usual frame ",
      std::lround(100 * updates),
      " % are not the SPUs'. Ruined is called here: more than half of it, and a longest frame longer than "
      "control's.",
      steps_text(results.moving_steps, "cell-paper", kRuined),
      resident_text(results, kRuined, Measure::longest));
  return finding;
}

}  // namespace

std::vector<Finding> judge(const ExperimentResults& results) {
  return {judge_initial(results), judge_static(results), judge_spus(results), judge_flat(results),
          judge_updates(results)};
}

std::string verdict_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds here";
    case Verdict::fails:
      return "does not hold here";
    default:
      return "cannot be judged here";
  }
}

}  // namespace cellsweep::report
