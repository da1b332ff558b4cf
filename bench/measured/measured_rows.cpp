#include "bench/measured/measured_rows.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

namespace cellsweep::bench {
namespace {

using nlohmann::json;

std::vector<std::string> parts_of(const std::string& name) {
  std::vector<std::string> parts;
  std::istringstream rest(name);
  for (std::string part; std::getline(rest, part, '/');) parts.push_back(part);
  if (parts.empty()) parts.emplace_back();
  return parts;
}

double seconds_of(const json& row) {
  const std::string unit = row.value("time_unit", "ns");
  const double scale = unit == "s" ? 1 : unit == "ms" ? 1e-3 : unit == "us" ? 1e-6 : 1e-9;
  return row.value("real_time", 0.0) * scale;
}

bool is_aggregate(const json& row, std::string_view name) {
  return row.value("run_type", "") == "aggregate" && row.value("aggregate_name", "") == name;
}

std::string machine_of(const json& context) {
  const std::string giant = context.value("giant", "");
  return (giant.empty() ? "" : "with a giant (" + giant + "): ") + context.value("cpu", "") + ", " +
         context.value("cores", "") + " cores, " + context.value("compiler", "") + ", commit " +
         context.value("commit", "");
}

// Google Benchmark writes the spread of counters that are zero as NaN, which JSON has not.
std::string with_zeros_for_nan(std::string_view text_of_file) {
  std::string result(text_of_file);
  for (const std::string_view nan : {": NaN", ": -NaN"}) {
    for (std::size_t at = result.find(nan); at != std::string::npos; at = result.find(nan, at))
      result.replace(at, nan.size(), ": 0");
  }
  return result;
}

/// What a file says of the row of one name.
struct Measurements {
  std::vector<const json*> rows;
  std::vector<const json*> medians;
  double spread_of_repetitions = 0;
};

// Standard deviation over mean.
double spread_of(const Measurements& of) {
  if (of.rows.size() == 1) return of.spread_of_repetitions;
  double sum = 0, squares = 0;
  for (const json* row : of.rows) sum += seconds_of(*row);
  const auto count = static_cast<double>(of.rows.size());
  const double mean = sum / count;
  for (const json* row : of.rows) squares += (seconds_of(*row) - mean) * (seconds_of(*row) - mean);
  return mean > 0 ? std::sqrt(squares / (count - 1)) / mean : 0;
}

MeasuredRow row_of(Measurements of, const std::string& name) {
  std::vector<double> turns;
  for (const json* measured : of.rows) turns.push_back(seconds_of(*measured));
  auto& rows = of.rows;
  const auto middle = rows.begin() + static_cast<std::ptrdiff_t>(rows.size() / 2);
  std::nth_element(rows.begin(), middle, rows.end(),
                   [](const json* a, const json* b) { return seconds_of(*a) < seconds_of(*b); });
  MeasuredRow row{parts_of(name), seconds_of(**middle), spread_of(of), std::move(turns), {}};
  for (const auto& [key, value] : (*middle)->items()) {
    if (value.is_number()) row.counters[key] = value.get<double>();
  }
  return row;
}

// A median that Google Benchmark took of repetitions is a measurement like others, unless these are there,
// too.
std::vector<MeasuredRow> rows_of(const json& list) {
  std::map<std::string, Measurements> measured;
  std::vector<std::string> names;
  for (const json& row : list) {
    const std::string name = row.value("run_name", "");
    const bool is_median = is_aggregate(row, "median");
    Measurements& of_name = measured[name];
    if (is_aggregate(row, "cv")) of_name.spread_of_repetitions = row.value("real_time", 0.0);
    if (!is_median && row.value("run_type", "") != "iteration") continue;
    if (row.value("error_occurred", false)) continue;
    if (of_name.rows.empty() && of_name.medians.empty()) names.push_back(name);
    (is_median ? of_name.medians : of_name.rows).push_back(&row);
  }
  std::vector<MeasuredRow> rows;
  rows.reserve(names.size());
  for (const std::string& name : names) {
    Measurements& of_name = measured[name];
    if (of_name.rows.empty()) of_name.rows.swap(of_name.medians);
    rows.push_back(row_of(of_name, name));
  }
  return rows;
}

double middle_of(std::vector<double> numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

}  // namespace

double ratio_in_turns(std::span<const double> one, std::span<const double> other) {
  if (one.size() != other.size())
    return middle_of({one.begin(), one.end()}) / middle_of({other.begin(), other.end()});
  std::vector<double> quotients(one.begin(), one.end());
  for (std::size_t turn = 0; turn < quotients.size(); ++turn) quotients[turn] /= other[turn];
  return middle_of(std::move(quotients));
}

double MeasuredRow::counter(const std::string& name) const {
  const auto found = counters.find(name);
  return found == counters.end() ? 0 : found->second;
}

std::optional<std::size_t> number_in(std::string_view part) {
  std::size_t number = 0;
  const char* end = part.data() + part.size();
  const auto read = std::from_chars(part.data(), end, number);
  return read.ec == std::errc() && read.ptr == end ? std::optional(number) : std::nullopt;
}

Result<MeasuredRows> read_measured_rows(std::string_view text_of_file) {
  const Status refused = Status::bad_input("This is no JSON that Google Benchmark wrote.");
  const json file = json::parse(with_zeros_for_nan(text_of_file), nullptr, false);
  if (file.is_discarded() || !file.is_object() || !file.contains("benchmarks")) return refused;
  try {
    MeasuredRows measured;
    if (file.contains("context")) measured.machine = machine_of(file["context"]);
    measured.rows = rows_of(file["benchmarks"]);
    return measured;
  } catch (const json::exception&) {
    return refused;
  }
}

}  // namespace cellsweep::bench
