#include "report/experiment/figure_plot.h"

#include <algorithm>

#include "base/text.h"
#include "report/units.h"

namespace cellsweep::report {
namespace {

std::string in_quotes(std::string_view words) {
  std::string result = "'";
  for (const char c : words) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

// Whole frames have unbroken lines, parts of them broken ones.
std::string dash_of(Part part) {
  switch (part) {
    case Part::spus:
      return "dt '-'";
    case Part::longest_spu:
      return "dt '.'";
    case Part::simulated_cell:
      return "dt '_.'";
    default:
      return "dt solid";
  }
}

// Seconds, for gnuplot's unit prefixes.
std::string data_block(const CurveResult& result, std::size_t number, Measure measure) {
  std::string block = text("$curve", number, " << END\n");
  for (const auto& [bodies, times] : result.points) {
    const Spread& time = times[measure];
    block += text(bodies, " ", time.median / 1e6, " ", time.lowest / 1e6, " ", time.highest / 1e6, "\n");
  }
  return block + "END\n";
}

// The range of the repetitions thinly, and the line over it.
std::string plot_entry(const CurveResult& result, std::size_t number) {
  const std::string color = in_quotes(result.curve.color);
  return text("  $curve", number, " using 1:2:3:4 with yerrorbars notitle lc rgb ", color,
              " lw 0.8 pt 0, \\\n", "  $curve", number, " using 1:2 with linespoints title ",
              in_quotes(result.curve.label), " lc rgb ", color, " lw 2.4 pt 7 ps 0.7 ",
              dash_of(result.curve.part));
}

constexpr double kMargin = 1.25;  // beside the first and last size

std::string size_tics(const std::vector<std::size_t>& sizes) {
  std::string tics;
  for (const std::size_t bodies : sizes) {
    tics += text(tics.empty() ? "" : ", ", in_quotes(count_text(bodies)), " ", bodies);
  }
  const auto [least, most] = std::minmax_element(sizes.begin(), sizes.end());
  return text("set xtics (", tics, ")\nset xrange [", static_cast<double>(*least) / kMargin, ":",
              static_cast<double>(*most) * kMargin, "]\n");
}

constexpr std::string_view kLook =
    "set encoding utf8\n"
    "set micro\n"
    "set logscale xy\n"
    "set format y '%.0s %cs'\n"
    "set mytics 10\n"
    "set grid ytics mytics xtics lt 1 lc rgb '#cfd5dc' lw 0.8, lt 1 lc rgb '#eceff2' lw 0.5\n"
    "set border 3 lc rgb '#555555'\n"
    "set tics nomirror\n"
    "set key outside right center Left reverse samplen 2.5 spacing 1.3 width -3\n"
    "set bars 0.6\n";

constexpr std::string_view kSvg =
    "set terminal svg size 900,480 font 'Helvetica,Arial,sans-serif,14' background '#ffffff'\n";
constexpr std::string_view kPng =
    "set terminal pngcairo size 1350,720 font 'sans,14' fontscale 1.15 linewidth 1.4 background "
    "'#ffffff'\n";

// What is drawn, whatever on.
std::string subject_of(const Figure& figure, const ExperimentResults& results) {
  const auto curves = curves_of(figure, results);
  std::string script;
  for (std::size_t i = 0; i < curves.size(); ++i) script += data_block(*curves[i], i, figure.measure);
  script += kLook;
  script += size_tics(results.settings.bodies);
  script += "set title " + in_quotes(figure.title) + "\n";
  script += "set xlabel 'boxes in the world'\n";
  return script + text("set ylabel ", in_quotes(text(figure.y_label, ", logarithmic")), "\n");
}

std::string plot_of(const Figure& figure, const ExperimentResults& results) {
  const auto curves = curves_of(figure, results);
  std::string plot = "plot \\\n";
  for (std::size_t i = 0; i < curves.size(); ++i)
    plot += plot_entry(*curves[i], i) + (i + 1 < curves.size() ? ", \\\n" : "\n");
  return plot;
}

}  // namespace

std::string figure_script(const Figure& figure, const ExperimentResults& results) {
  const std::string plot = plot_of(figure, results);
  const auto file = [&](const char* ending) { return in_quotes(std::string(figure.id) + ending); };
  return text("# Draws ", figure.id, ".svg and ", figure.id, ".png: gnuplot ", figure.id, ".gnuplot\n",
              subject_of(figure, results), kSvg, "set output ", file(".svg"), "\n", plot, "unset output\n",
              kPng, "set output ", file(".png"), "\n", plot, "unset output\n");
}

std::string drawing_script(const Figure& figure, const ExperimentResults& results, Drawing drawing) {
  return text(subject_of(figure, results), drawing == Drawing::svg ? kSvg : kPng, plot_of(figure, results));
}

}  // namespace cellsweep::report
