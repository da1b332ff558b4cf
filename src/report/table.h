/// @file
/// A table of text for a terminal.
#pragma once

#include <string>
#include <vector>

namespace cellsweep::report {

/// Columns are as wide as their widest cell, in characters of UTF-8; the first `left_columns` are aligned
/// left, the others right.
class Table {
 public:
  explicit Table(std::vector<std::string> head, std::size_t left_columns = 1);

  /// A row with as many cells as the head.
  void add(std::vector<std::string> row);

  /// Head, a rule, and the rows; every line ends in a newline.
  std::string text() const;

 private:
  std::size_t width_of(std::size_t column) const;
  std::string line(const std::vector<std::string>& row) const;

  std::vector<std::vector<std::string>> rows_;
  std::size_t left_columns_;
};

}  // namespace cellsweep::report
