#include "isa/debug/source_lines.h"

#include <algorithm>
#include <fstream>
#include <tuple>

namespace spu_emu::isa {

namespace {
bool ends_in(std::string_view path, std::string_view name) {
  if (!path.ends_with(name)) return false;
  const std::size_t before = path.size() - name.size();
  return before == 0 || path[before - 1] == '/';
}
}  // namespace

/// Where one piece of code ends and another begins, the end comes first.
SourceLines::SourceLines(std::vector<std::string> files, std::vector<LineRow> rows)
    : files_(std::move(files)), rows_(std::move(rows)) {
  std::stable_sort(rows_.begin(), rows_.end(), [](const LineRow& a, const LineRow& b) {
    return std::tuple(a.address, !a.end) < std::tuple(b.address, !b.end);
  });
}

std::optional<LineRow> SourceLines::at(std::uint32_t address) const {
  const auto behind =
      std::upper_bound(rows_.begin(), rows_.end(), address,
                       [](std::uint32_t wanted, const LineRow& row) { return wanted < row.address; });
  if (behind == rows_.begin()) return std::nullopt;
  const LineRow& row = *(behind - 1);
  if (row.end || row.line == 0) return std::nullopt;
  return row;
}

bool SourceLines::begins_statement(std::uint32_t address) const {
  const auto row = at(address);
  return row && row->address == address && row->statement;
}

std::vector<std::uint32_t> SourceLines::files_named(std::string_view name) const {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < files_.size(); ++i) {
    if (ends_in(files_[i], name)) found.push_back(i);
  }
  return found;
}

std::optional<LineCode> SourceLines::code_of(std::uint32_t file, std::uint32_t line) const {
  LineCode code{file, UINT32_MAX, {}};
  for (const LineRow& row : rows_) {
    const bool counts = !row.end && row.statement && row.file == file && row.line >= line;
    if (!counts || row.line > code.line || row.line == 0) continue;
    if (row.line < code.line) code = {file, row.line, {}};
    if (code.addresses.empty() || code.addresses.back() != row.address) code.addresses.push_back(row.address);
  }
  if (code.addresses.empty()) return std::nullopt;
  return code;
}

std::uint32_t SourceLines::last_line(std::uint32_t file) const {
  std::uint32_t last = 0;
  for (const LineRow& row : rows_) {
    if (!row.end && row.file == file) last = std::max(last, row.line);
  }
  return last;
}

std::string file_name(std::string_view path) {
  return std::string(path.substr(path.rfind('/') + 1));
}

std::vector<std::string> read_source(const std::string& path, std::uint32_t first, std::uint32_t last) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  std::string text;
  for (std::uint32_t number = 1; number <= last && std::getline(file, text); ++number) {
    if (number >= first) lines.push_back(text);
  }
  return lines;
}

}  // namespace spu_emu::isa
