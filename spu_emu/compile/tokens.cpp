#include "compile/tokens.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>

namespace spu_emu::compile {

namespace {

bool begins_word(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
}
bool in_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
}
bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Marks of several characters that matter to where an expression ends; others are taken apart.
constexpr std::array<std::string_view, 13> kLongMarks = {"->*", "...", "->", "++", "--", "::", "&&",
                                                         "||",  "<<",  "==", "!=", "<=", ">="};

class Lexer {
 public:
  explicit Lexer(std::string_view source) : source_(source) {}

  std::vector<Token> run() {
    while (at_ < source_.size()) step();
    return std::move(tokens_);
  }

 private:
  void step() {
    const char c = source_[at_];
    if (c == '\n') {
      at_line_begin_ = true;
      ++at_;
    } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      ++at_;
    } else if (c == '#' && at_line_begin_) {
      read_directive();
    } else {
      at_line_begin_ = false;
      add(kind_and_size());
    }
  }

  /// The flag 3 of a line marker says that what follows is of a system header.
  void read_directive() {
    const std::string_view line = source_.substr(at_, source_.find('\n', at_) - at_);
    at_ += line.size();
    if (line.size() < 3 || line[1] != ' ' || !is_digit(line[2])) return;
    const std::size_t quote = line.rfind('"');
    in_system_header_ = quote != std::string_view::npos && line.find(" 3", quote) != std::string_view::npos;
  }

  struct Piece {
    Token::Kind kind;
    std::size_t size;
  };

  Piece kind_and_size() const {
    const char c = source_[at_];
    if (begins_word(c)) return word_or_text();
    if (is_digit(c) || (c == '.' && at_ + 1 < source_.size() && is_digit(source_[at_ + 1]))) {
      return {Token::Kind::number, number_size()};
    }
    if (c == '"' || c == '\'') return {Token::Kind::text, quoted_size(at_)};
    for (const std::string_view mark : kLongMarks) {
      if (source_.substr(at_, mark.size()) == mark) return {Token::Kind::mark, mark.size()};
    }
    return {Token::Kind::mark, 1};
  }

  /// A prefix like u8 or LR belongs to the literal behind it.
  Piece word_or_text() const {
    std::size_t end = at_;
    while (end < source_.size() && in_word(source_[end])) ++end;
    const std::string_view word = source_.substr(at_, end - at_);
    const bool is_prefix = word == "L" || word == "u" || word == "U" || word == "u8";
    const bool is_raw = word == "R" || word == "LR" || word == "uR" || word == "UR" || word == "u8R";
    const char next = end < source_.size() ? source_[end] : '\0';
    if (is_raw && next == '"') return {Token::Kind::text, end - at_ + raw_size(end)};
    if (is_prefix && (next == '"' || next == '\'')) return {Token::Kind::text, end - at_ + quoted_size(end)};
    return {Token::Kind::word, word.size()};
  }

  std::size_t number_size() const {
    std::size_t end = at_;
    while (end < source_.size()) {
      const char c = source_[end];
      const char before = end > at_ ? source_[end - 1] : '\0';
      const bool is_exponent = before == 'e' || before == 'E' || before == 'p' || before == 'P';
      const bool is_hexadecimal = source_.substr(at_, 2) == "0x" || source_.substr(at_, 2) == "0X";
      const bool is_sign =
          (c == '+' || c == '-') && is_exponent && (!is_hexadecimal || before == 'p' || before == 'P');
      const bool is_separator = c == '\'' && end + 1 < source_.size() && in_word(source_[end + 1]);
      if (!in_word(c) && c != '.' && !is_sign && !is_separator) break;
      ++end;
    }
    return end - at_;
  }

  std::size_t quoted_size(std::size_t begin) const {
    std::size_t end = begin + 1;
    while (end < source_.size() && source_[end] != source_[begin] && source_[end] != '\n') {
      end += source_[end] == '\\' ? 2 : 1;
    }
    return std::min(end + 1, source_.size()) - begin;
  }

  std::size_t raw_size(std::size_t begin) const {
    const std::size_t open = source_.find('(', begin);
    if (open == std::string_view::npos) return source_.size() - begin;
    std::string close(1, ')');
    close.append(source_.substr(begin + 1, open - begin - 1)).push_back('"');
    const std::size_t end = source_.find(close, open);
    return end == std::string_view::npos ? source_.size() - begin : end + close.size() - begin;
  }

  void add(Piece piece) {
    if (!in_system_header_) tokens_.push_back({piece.kind, at_, source_.substr(at_, piece.size)});
    at_ += piece.size;
  }

  std::string_view source_;
  std::size_t at_ = 0;
  bool at_line_begin_ = true;
  bool in_system_header_ = false;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokens_of(std::string_view source) {
  return Lexer(source).run();
}

}  // namespace spu_emu::compile
