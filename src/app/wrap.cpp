#include "app/wrap.h"

#include <algorithm>

namespace cellsweep::app {
namespace {

// Of UTF-8, whose bytes behind a character's first begin with the bits 10.
std::size_t width_of(std::string_view word) {
  return static_cast<std::size_t>(std::count_if(
      word.begin(), word.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

/// Puts word after word.
class Lines {
 public:
  Lines(std::size_t start, std::size_t indent) : column_(start), line_start_(start), indent_(indent) {}

  void add(std::string_view word) {
    const bool first = column_ == line_start_;
    if (!first && column_ + 1 + width_of(word) > kColumns) {
      end_line();
    } else if (!first) {
      add_text(" ");
    }
    add_text(word);
  }

  void end_line() {
    text_ += "\n" + std::string(indent_, ' ');
    column_ = line_start_ = indent_;
  }

  std::string take() { return std::move(text_); }

 private:
  void add_text(std::string_view words) {
    text_ += words;
    column_ += width_of(words);
  }

  std::string text_;
  std::size_t column_;
  std::size_t line_start_;
  std::size_t indent_;
};

}  // namespace

std::string wrapped(std::string_view text, std::size_t start, std::size_t indent) {
  Lines lines(start, indent);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \n"), text.size());
    if (end > 0) lines.add(text.substr(0, end));
    if (end < text.size() && text[end] == '\n') lines.end_line();
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines.take();
}

}  // namespace cellsweep::app
