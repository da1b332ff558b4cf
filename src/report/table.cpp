#include "report/table.h"

#include <algorithm>
#include <utility>

namespace cellsweep::report {
namespace {

// Names come out of strangers' files; a terminal must not obey them.
bool is_control(char c) {
  const auto code = static_cast<unsigned char>(c);
  return code < 0x20 || code == 0x7f;
}

// Of UTF-8, whose bytes behind a character's first begin with the bits 10.
std::size_t width_of_text(const std::string& cell) {
  return static_cast<std::size_t>(std::count_if(
      cell.begin(), cell.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

}  // namespace

Table::Table(std::vector<std::string> head, std::size_t left_columns) : left_columns_(left_columns) {
  rows_.push_back(std::move(head));
}

void Table::add(std::vector<std::string> row) {
  for (std::string& cell : row) {
    std::replace_if(cell.begin(), cell.end(), is_control, '?');
  }
  rows_.push_back(std::move(row));
}

std::size_t Table::width_of(std::size_t column) const {
  std::size_t width = 0;
  for (const auto& row : rows_) width = std::max(width, width_of_text(row[column]));
  return width;
}

std::string Table::line(const std::vector<std::string>& row) const {
  std::string result;
  for (std::size_t column = 0; column < row.size(); ++column) {
    const std::string padding(width_of(column) - width_of_text(row[column]), ' ');
    if (column > 0) result += "  ";
    result += column < left_columns_ ? row[column] + padding : padding + row[column];
  }
  result.erase(result.find_last_not_of(' ') + 1);
  return result + "\n";
}

std::string Table::text() const {
  std::vector<std::string> rule;
  for (std::size_t column = 0; column < rows_.front().size(); ++column) {
    rule.emplace_back(width_of(column), '-');
  }
  std::string result = line(rows_.front()) + line(rule);
  for (std::size_t i = 1; i < rows_.size(); ++i) result += line(rows_[i]);
  return result;
}

}  // namespace cellsweep::report
