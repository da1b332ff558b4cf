#include "compile/align_data.h"

#include <charconv>
#include <set>

namespace spu_emu::compile {

namespace {

constexpr unsigned kAlignment = 16;

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// Of `.type NAME, @object` the name.
std::string_view object_of(std::string_view line) {
  if (!line.starts_with(".type")) return {};
  const std::size_t comma = line.find(',');
  if (comma == std::string_view::npos || trimmed(line.substr(comma + 1)).substr(0, 7) != "@object") return {};
  return trimmed(line.substr(5, comma - 5));
}

/// `.comm NAME,SIZE,ALIGNMENT`, which is how uninitialised data may be written.
std::string aligned_common(std::string_view line) {
  const std::size_t size = line.find(',');
  const std::size_t alignment = size == std::string_view::npos ? size : line.find(',', size + 1);
  if (alignment == std::string_view::npos) return std::string(line);
  const std::string_view number = trimmed(line.substr(alignment + 1));
  unsigned value = 0;
  std::from_chars(number.data(), number.data() + number.size(), value);
  if (value >= kAlignment) return std::string(line);
  return std::string(line.substr(0, alignment + 1)) + std::to_string(kAlignment);
}

}  // namespace

std::string align_data(std::string_view assembly) {
  std::set<std::string, std::less<>> objects;
  std::string result;
  while (!assembly.empty()) {
    const std::size_t end = assembly.find('\n');
    const std::string_view line = assembly.substr(0, end);
    assembly.remove_prefix(end == std::string_view::npos ? assembly.size() : end + 1);
    const std::string_view statement = trimmed(line);
    if (const std::string_view object = object_of(statement); !object.empty()) objects.emplace(object);
    const std::size_t colon = line.find(':');
    if (colon != std::string_view::npos && objects.contains(line.substr(0, colon))) {
      result += "\t.balign " + std::to_string(kAlignment) + "\n";
    }
    result += statement.starts_with(".comm") ? aligned_common(line) : std::string(line);
    result += '\n';
  }
  return result;
}

}  // namespace spu_emu::compile
