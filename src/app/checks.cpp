#include "app/checks.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <utility>

#include "app/setting_flags.h"
#include "base/text.h"
#include "report/units.h"

namespace cellsweep::app {
namespace {

template <class Number>
bool read(const std::string& value, Number& number) {
  const char* const end = value.data() + value.size();
  const auto [last, error] = std::from_chars(value.data(), end, number);
  return error == std::errc() && last == end;
}

// "0 or more" or "1 to 16,384".
std::string range_text(std::uint64_t least, std::uint64_t most) {
  if (most == std::numeric_limits<std::uint64_t>::max()) return report::count_text(least) + " or more";
  return report::count_text(least) + " to " + report::count_text(most);
}

std::string range_text(double least, double most) {
  return std::isinf(most) ? text(least, " or more") : text(least, " to ", most);
}

CLI::Validator validator(std::function<std::string(std::string&)> check) {
  return {std::move(check), ""};
}

std::string lower(std::string letters) {
  for (char& c : letters) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  return letters;
}

}  // namespace

CLI::Validator count(std::uint64_t least, std::uint64_t most) {
  return validator([=](const std::string& value) {
    std::uint64_t number = 0;
    if (read(value, number) && number >= least && number <= most) return std::string();
    return text("a whole number, ", range_text(least, most), ", is wanted, not \"", value, "\".");
  });
}

CLI::Validator number(double least, double most) {
  return validator([=](const std::string& value) {
    double number = 0;
    if (read(value, number) && std::isfinite(number) && number >= least && number <= most)
      return std::string();
    return text("a number, ", range_text(least, most), ", is wanted, not \"", value, "\".");
  });
}

CLI::Validator one_of(std::vector<std::string_view> words) {
  return validator([words = std::move(words)](const std::string& value) {
    if (std::find(words.begin(), words.end(), value) != words.end()) return std::string();
    return text("one of ", names_text(words), " is wanted, not \"", value, "\".");
  });
}

Status check_ending(const std::filesystem::path& file, std::initializer_list<std::string_view> endings) {
  const std::string ending = lower(file.extension().string());
  if (std::find(endings.begin(), endings.end(), ending) != endings.end()) return {};
  std::string all;
  for (const std::string_view one : endings) all += (all.empty() ? "" : " or ") + std::string(one);
  return Status::bad_input(
      text(file.string(), ": what a file is goes by its ending, and here it must be ", all, "."));
}

}  // namespace cellsweep::app
