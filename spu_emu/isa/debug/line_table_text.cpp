#include "isa/debug/line_table_text.h"

#include <map>
#include <sstream>

#include "mfc/format.h"

namespace spu_emu::isa {

std::string line_table_text(const SourceLines& lines) {
  std::string text;
  const std::string* file = nullptr;
  for (const LineRow& row : lines.rows()) {
    if (file != &lines.file(row.file)) {
      file = &lines.file(row.file);
      text += "file " + *file + "\n";
    }
    text += format("0x%05x %u %s\n", row.address, row.line,
                   row.end         ? "end"
                   : row.statement ? "statement"
                                   : "inside");
  }
  return text;
}

SourceLines read_line_table(std::istream& text) {
  std::vector<std::string> files;
  std::map<std::string, std::uint32_t> numbers;
  std::vector<LineRow> rows;
  LineRow row;
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with("file ")) {
      const std::string path = line.substr(5);
      const auto [place, is_new] = numbers.try_emplace(path, static_cast<std::uint32_t>(files.size()));
      if (is_new) files.push_back(path);
      row.file = place->second;
      continue;
    }
    std::istringstream words(line);
    std::string kind;
    if (files.empty() || !(words >> std::hex >> row.address >> std::dec >> row.line >> kind)) continue;
    row.statement = kind == "statement";
    row.end = kind == "end";
    rows.push_back(row);
  }
  return {std::move(files), std::move(rows)};
}

}  // namespace spu_emu::isa
