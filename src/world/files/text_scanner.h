/// @file
/// Takes a small text apart, token by token, and says at which byte of its file it went wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "world/files/file_fault.h"

namespace cellsweep {

/// A text of a file, read from left to right. It does not own the text. Positions count from the text's
/// begin.
class TextScanner {
 public:
  /// `offset` is where the text begins in its file.
  TextScanner(std::string_view text, std::size_t offset) : text_(text), offset_(offset) {}

  std::size_t position() const { return at_; }
  std::size_t file_offset(std::size_t position) const { return offset_ + position; }
  std::string_view text_from(std::size_t position) const { return text_.substr(position, at_ - position); }

  void skip_space() {
    while (at_ < text_.size() && is_space(text_[at_])) ++at_;
  }

  bool at_end() const { return at_ == text_.size(); }

  /// Takes a character if it is the next after any space.
  bool take(char c) {
    skip_space();
    if (at_end() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

  /// Takes letters; empty when there are none.
  std::string_view take_word() {
    skip_space();
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    return text_from(begin);
  }

  /// Takes a string in single or double quotes and gives what is between them.
  bool take_string(std::string_view& content) {
    skip_space();
    if (at_end() || (text_[at_] != '\'' && text_[at_] != '"')) return false;
    const std::size_t end = text_.find(text_[at_], at_ + 1);
    if (end == std::string_view::npos) return false;
    content = text_.substr(at_ + 1, end - at_ - 1);
    at_ = end + 1;
    return true;
  }

  /// Takes a number without a sign; false, and nothing taken, when there is none or it does not fit 64 bits.
  bool take_count(std::uint64_t& count) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::uint64_t>::max();
    skip_space();
    const std::size_t begin = at_;
    count = 0;
    while (at_ < text_.size() && is_digit(text_[at_])) {
      const auto digit = static_cast<std::uint64_t>(text_[at_] - '0');
      if (count > (kMost - digit) / 10) break;
      count = count * 10 + digit;
      ++at_;
    }
    if (at_ > begin && (at_end() || !is_digit(text_[at_]))) return true;
    at_ = begin;
    return false;
  }

  /// "byte 31: expected ..., found 'x'", for the next character.
  Status expected(std::string_view what) {
    skip_space();
    const std::string found = at_end() ? "the end of the header" : quoted(text_.substr(at_));
    return fault_at(file_offset(at_), what, found);
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

  std::string_view text_;
  std::size_t offset_ = 0;
  std::size_t at_ = 0;
};

}  // namespace cellsweep
