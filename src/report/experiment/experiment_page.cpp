#include "report/experiment/experiment_page.h"

#include <algorithm>
#include <string_view>

#include "base/text.h"
#include "cellsweep/world/scene.h"
#include "report/experiment/figure_csv.h"
#include "report/experiment/figure_plot.h"
#include "report/experiment/figures.h"
#include "report/experiment/findings.h"
#include "report/experiment/html.h"
#include "report/experiment/standing.h"
#include "report/gnuplot.h"
#include "report/picture/picture.h"
#include "report/text_file.h"
#include "report/units.h"

namespace cellsweep::report {
namespace {

constexpr std::string_view kStyle = R"(
body { margin: 0; background: #f3f5f8; color: #1d232b; font: 16px/1.55 system-ui, "Helvetica Neue", Arial, sans-serif; }
main { max-width: 960px; margin: 0 auto; padding: 32px 20px 64px; }
h1 { font-size: 30px; line-height: 1.2; margin: 0 0 6px; }
h2 { font-size: 21px; margin: 0 0 2px; }
section { background: #fff; border: 1px solid #dfe4ea; border-radius: 10px; padding: 22px 24px; margin: 22px 0; }
p { margin: 8px 0; }
.dim { color: #5a6673; }
.finding { border-left: 4px solid #8a95a3; padding: 2px 0 2px 14px; margin: 14px 0; }
.holds { border-color: #1f9d55; }
.fails { border-color: #d1495b; }
.verdict { font-weight: 600; }
.holds .verdict { color: #157f43; }
.fails .verdict { color: #b3293d; }
svg, img { display: block; width: 100%; height: auto; }
img { border-radius: 6px; }
.table { overflow-x: auto; }
table { border-collapse: collapse; font-size: 14px; font-variant-numeric: tabular-nums; width: 100%; }
th, td { text-align: right; padding: 5px 10px; border-bottom: 1px solid #e6eaef; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; }
th { color: #5a6673; font-weight: 600; white-space: normal; vertical-align: bottom; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 4px 18px; margin: 10px 0 0; font-size: 14px; }
dt { color: #5a6673; }
dd { margin: 0; overflow-wrap: anywhere; }
)";

std::string class_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::holds:
      return "holds";
    case Verdict::fails:
      return "fails";
    default:
      return "unknown";
  }
}

std::string verdict_html(const Finding& finding, const std::string& more) {
  const std::string verdict =
      html_element("span", html_text(verdict_text(finding.verdict)), "class=\"verdict\"");
  return html_element("div", html_element("p", html_text(finding.claim) + " — " + verdict) + more,
                      "class=\"finding " + class_of(finding.verdict) + "\"");
}

std::string finding_html(const Finding& finding) {
  return verdict_html(
      finding,
      html_element("p", html_text(finding.text)) +
          html_element("p", "What the dissertation says in its chapter " + html_text(finding.chapter) + ".",
                       "class=\"dim\""));
}

std::string paragraph_html(const std::string& words) {
  return words.empty() ? "" : html_element("p", html_text(words));
}

std::string numbers_html(const Figure& figure, const ExperimentResults& results) {
  std::vector<std::vector<std::string>> rows = {{"boxes"}};
  for (const std::size_t bodies : results.settings.bodies) rows.push_back({count_text(bodies)});
  for (const CurveResult* result : curves_of(figure, results)) {
    rows[0].emplace_back(result->curve.label);
    for (std::size_t i = 0; i < results.settings.bodies.size(); ++i) {
      const auto point = result->points.find(results.settings.bodies[i]);
      rows[i + 1].push_back(point == result->points.end() ? ""
                                                          : time_text(point->second[figure.measure].median));
    }
  }
  return html_table(rows);
}

std::string figure_html(const Figure& figure, const ExperimentResults& results,
                        const std::vector<Finding>& findings, const std::string& svg) {
  std::string caption(figure.caption);
  caption += figure.document.empty() ? " Not in the dissertation."
                                     : " The dissertation's " + std::string(figure.document) + ".";
  std::string html = html_element("h2", html_text(figure.title)) +
                     html_element("p", html_text(caption), "class=\"dim\"") + inline_svg(svg, figure.title);
  if (figure.curves.empty()) html += paragraph_html(standing_text(results, figure.measure));
  for (const Finding& finding : findings) {
    if (finding.figure == figure.id) html += finding_html(finding);
  }
  return html_element("section", html + numbers_html(figure, results));
}

std::string picture_html(const ExperimentResults& results, const std::string& png) {
  if (png.empty()) return {};
  const std::size_t bodies = results.settings.bodies.back();
  const std::string words =
      text("Scene paper with ", count_text(bodies), " boxes; those that collide are green");
  return html_element("section", "<img alt=\"" + words + "\" src=\"data:image/png;base64," + base64(png) +
                                     "\">\n" + html_element("p", html_text(words + "."), "class=\"dim\""));
}

// Those that have a curve: ", with control, cell-paper and stream of cellsweep".
std::string with_engines_text(const ExperimentResults& results) {
  std::vector<std::string_view> names;
  for (const CurveResult& result : results.curves) {
    if (std::find(names.begin(), names.end(), result.curve.engine) == names.end())
      names.push_back(result.curve.engine);
  }
  if (names.empty()) return {};
  std::string words = text(", with ", names.front());
  for (std::size_t i = 1; i < names.size(); ++i)
    words += text(i + 1 == names.size() ? " and " : ", ", names[i]);
  return words + " of cellsweep";
}

// What the reader gets, before any number.
std::string subject_html(const ExperimentResults& results) {
  const std::string sizes = text(count_text(results.settings.bodies.front()), " to ",
                                 count_text(results.settings.bodies.back()), " boxes");
  return html_element("h1", "What a frame of collision detection takes") +
         html_element(
             "p",
             html_text(text("The time that it takes to find all overlapping pairs among ", sizes,
                            with_engines_text(results),
                            ", on one machine: when all boxes are new, when none moves and when "
                            "one in ten does. There is a figure for each, with its numbers below it.")),
             "class=\"dim\"") +
         html_element(
             "p",
             html_text(
                 "control and cell-paper are the x86 version and the Cell version of “Broadphase Collision "
                 "Detection on the Cell Processor” (2010), cell-brute and cell-resident what else fits a "
                 "Cell, "
                 "its SPUs emulated at full speed on this machine's cores; embree is there for comparison. "
                 "stream is the engine to use: it takes any number of boxes."),
             "class=\"dim\"");
}

// The engine to use, in the three kinds of frames.
std::string standings_html(const ExperimentResults& results) {
  std::vector<std::pair<std::string, std::string>> entries;
  for (const auto& [name, measure] :
       {std::pair{std::string("all new"), Measure::initial},
        std::pair{std::string("none moves"), Measure::still},
        std::pair{text(100 * results.settings.moving, " % move"), Measure::median}}) {
    if (std::string words = standing_text(results, measure); !words.empty())
      entries.emplace_back(name, std::move(words));
  }
  if (entries.empty()) return {};
  return html_element("section", html_element("h2", "Where stream stands") + html_list(entries));
}

std::string head_html(const ExperimentResults& results, const std::vector<Finding>& findings) {
  std::string list;
  for (const Finding& finding : findings) list += verdict_html(finding, "");
  return subject_html(results) + standings_html(results) +
         html_element("section",
                      html_element("h2", "What the dissertation found, and whether it holds here") + list);
}

// Sentences about what is not as it should be; the page must not hide them.
std::string notes_html(const ExperimentResults& results) {
  std::string html;
  if (!results.interrupted.empty())
    html += html_element("p", html_text(results.interrupted), "class=\"finding fails\"");
  for (const std::string& note : results.wrong)
    html += html_element("p", html_text(note), "class=\"finding fails\"");
  for (const std::string& note : results.left_out)
    html += html_element("p", html_text(note), "class=\"dim\"");
  return html;
}

std::string pairs_text(const ExperimentResults& results) {
  std::string pairs;
  for (const auto& [bodies, count] : results.pairs) {
    pairs += text(pairs.empty() ? "" : ", ", count_text(count), " of ", count_text(bodies), " boxes");
  }
  return pairs;
}

std::string context_html(const ExperimentResults& results) {
  std::vector<std::pair<std::string, std::string>> entries = results.context;
  for (auto& entry : settings_of(results.settings)) entries.push_back(std::move(entry));
  entries.emplace_back("pairs at the end", pairs_text(results));
  return html_element(
      "section",
      html_element("h2", "How it was measured") +
          html_element(
              "p",
              "Wall-clock time of an engine's own work: handing over what changed, and update(). Points are "
              "medians of the repetitions, bars their range. What control and cell-paper do once per body "
              "ever inserted, filling the map of all pairs, is left out, as in the dissertation. Every run's "
              "last pairs were compared with all-against-all. Of the simulated Cell there is what its "
              "slowest SPE "
              "takes, without starting threads and without the PPU.") +
          html_list(entries));
}

// Draws the picture and writes it to a file; gives its bytes.
Result<std::string> draw_as(Drawing drawing, const Figure& figure, const ExperimentResults& results,
                            const std::filesystem::path& file) {
  constexpr std::string_view kEndOfPng("IEND\xae\x42\x60\x82", 8);
  auto picture = run_gnuplot(file.string(), drawing_script(figure, results, drawing),
                             drawing == Drawing::svg ? "</svg>\n\n" : kEndOfPng);
  if (!picture) return picture.status();
  if (Status status = write_text_file(file, *picture); !status.ok()) return status;
  return picture;
}

// Gives the SVG picture.
Result<std::string> draw_figure(const Figure& figure, const ExperimentResults& results,
                                const std::filesystem::path& folder) {
  const auto file = [&](const char* ending) { return folder / (std::string(figure.id) + ending); };
  if (Status status = write_text_file(file(".csv"), figure_csv(figure, results)); !status.ok()) return status;
  if (Status status = write_text_file(file(".gnuplot"), figure_script(figure, results)); !status.ok())
    return status;
  const auto png = draw_as(Drawing::png, figure, results, file(".png"));
  if (!png) return png.status();
  return draw_as(Drawing::svg, figure, results, file(".svg"));
}

}  // namespace

Status draw_scene(const ExperimentSettings& settings, bool quick, const std::filesystem::path& path) {
  const SceneSettings scene{.bodies = *std::max_element(settings.bodies.begin(), settings.bodies.end()),
                            .seed = settings.seed,
                            .moving = settings.moving};
  const auto world = make_scene(scene);
  if (!world) return world.status();
  auto source = make_scene_frames(scene);
  if (!source) return source.status();
  for (std::size_t frame = 0; frame < settings.frames / 2; ++frame) (*source)->advance();
  PictureSettings picture;
  if (quick) picture.samples = 8;
  const auto image = trace_picture(tableau_of(**source, world->bounds()), picture);
  if (!image) return image.status();
  return write_png(*image, path);
}

Status write_experiment(const ExperimentResults& results, const std::filesystem::path& folder,
                        const std::filesystem::path& picture) {
  const std::vector<Finding> findings = judge(results);
  std::string png;
  if (!picture.empty()) {
    auto bytes = read_text_file(picture);
    if (!bytes) return bytes.status();
    png = std::move(*bytes);
  }
  std::string body = head_html(results, findings) + notes_html(results) + picture_html(results, png);
  for (const Figure& figure : figure_table()) {
    if (curves_of(figure, results).empty()) continue;
    const auto svg = draw_figure(figure, results, folder);
    if (!svg) return svg.status();
    body += figure_html(figure, results, findings, *svg);
  }
  body += context_html(results);
  const std::string page =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n"
      "<title>cellsweep: what a frame takes</title>\n" +
      html_element("style", kStyle) + "</head>\n" + html_element("body", html_element("main", body)) +
      "</html>\n";
  return write_text_file(folder / "report.html", page);
}

}  // namespace cellsweep::report
