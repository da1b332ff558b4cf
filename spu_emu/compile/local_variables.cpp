#include "compile/local_variables.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace spu_emu::compile {

namespace {

constexpr std::string_view kAttribute = "__attribute__((aligned(16))) ";

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_qualifier(std::string_view word) {
  return is_one_of(word, {"const", "volatile"});
}
bool is_built_in(std::string_view word) {
  return is_one_of(
      word, {"char", "short", "int", "long", "unsigned", "signed", "float", "double", "bool", "_Bool"});
}

/// What a statement may begin with, or a declaration of no variable on the stack, before a name.
bool begins_something_else(std::string_view word) {
  return is_one_of(word,
                   {"return",  "goto",     "delete",   "throw",  "case",  "else",      "do",       "new",
                    "typedef", "using",    "static",   "extern", "class", "namespace", "template", "typename",
                    "friend",  "register", "co_yield", "asm",    "enum",  "co_return", "not",      "auto"});
}

class LocalVariables {
 public:
  LocalVariables(const std::vector<Token>& tokens, Edits& edits) : tokens_(tokens), edits_(edits) {}

  void edit() {
    for (std::size_t at = 0; at < tokens_.size(); ++at) {
      if (is_in_code() && begins_statement(at) && declares_variable(at))
        edits_.insert(tokens_[at].begin, std::string(kAttribute));
      follow(at);
    }
  }

 private:
  std::string_view text(std::size_t at) const { return at < tokens_.size() ? tokens_[at].text : ""; }
  bool is_name(std::size_t at) const { return at < tokens_.size() && tokens_[at].kind == Token::Kind::word; }

  bool is_in_code() const { return !code_.empty() && code_.back(); }

  /// Keeps which of the open brackets hold code.
  void follow(std::size_t at) {
    if (tokens_[at].kind != Token::Kind::mark) return;
    const std::string_view mark = tokens_[at].text;
    if (mark == "(" || mark == "[") code_.push_back(false);
    if (mark == "{") code_.push_back(opens_code(at));
    if ((mark == ")" || mark == "]" || mark == "}") && !code_.empty()) code_.pop_back();
  }

  /// The body of a function, of the first kind of C's, too, whose parameters are declared before it, or a
  /// block in one.
  bool opens_code(std::size_t at) const {
    if (at == 0) return false;
    const std::string_view before = text(at - 1);
    if (is_one_of(before, {")", "]", "const", "noexcept", "override", "final", "mutable", "try"}))
      return true;
    if (before == "(") return code_.size() > 1 && code_[code_.size() - 2];  // a block that is an expression
    return before == ";" ? code_.empty() || is_in_code()
                         : is_in_code() && is_one_of(before, {"{", "}", ":", "else", "do"});
  }

  bool begins_statement(std::size_t at) const {
    return at > 0 && is_one_of(text(at - 1), {";", "{", "}", ":"});
  }

  bool declares_variable(std::size_t at) const {
    if (!is_name(at) || begins_something_else(text(at))) return false;
    std::size_t next = at;
    while (is_qualifier(text(next))) ++next;
    return is_built_in(text(next)) ? declares_built_in(next) : declares_named(next);
  }

  /// `unsigned int a`, `char *b`, but no `int(c)`, and no function.
  bool declares_built_in(std::size_t at) const {
    while (is_built_in(text(at)) || is_qualifier(text(at)) || text(at) == "*") ++at;
    return is_name(at) && text(at + 1) != "(";
  }

  /// `uint32_t a;`, `struct block b = ...`.
  bool declares_named(std::size_t at) const {
    if (is_one_of(text(at), {"struct", "union"})) ++at;
    return is_name(at) && is_name(at + 1) && is_one_of(text(at + 2), {";", "=", ",", "["}) &&
           !is_built_in(text(at + 1)) && !begins_something_else(text(at));
  }

  const std::vector<Token>& tokens_;
  Edits& edits_;
  std::vector<bool> code_;
};

}  // namespace

void align_local_variables(const std::vector<Token>& tokens, Edits& edits) {
  LocalVariables(tokens, edits).edit();
}

}  // namespace spu_emu::compile
