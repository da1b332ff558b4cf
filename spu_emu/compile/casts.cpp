#include "compile/casts.h"

#include <algorithm>
#include <array>
#include <string>

#include "compile/template_parameters.h"

namespace spu_emu::compile {

namespace {

bool is_one_of(std::string_view word, const auto& words) {
  return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

constexpr std::array<std::string_view, 8> kPrefixes = {"+", "-", "~", "!", "*", "&", "++", "--"};

/// Words behind which a parenthesis is no part of a call.
constexpr std::array<std::string_view, 6> kBeforeExpressions = {"return", "case",  "else",
                                                                "do",     "throw", "co_return"};

/// Words that cannot begin an operand: what stands before them is a parameter list.
constexpr std::array<std::string_view, 10> kAfterParameters = {
    "const", "volatile", "noexcept", "override", "final", "throw", "__attribute__", "__asm__", "asm", "try"};

/// Marks behind which an operand begins, and no declaration.
constexpr std::array<std::string_view, 19> kBeforeOperands = {
    "=", "(", ",", "?", "+", "-", "*", "/", "%", "|", "^", "~", "!", "&", "[", "==", "!=", "|=", "&="};

/// Words that say the type of an operand, which only the compiler knows.
constexpr std::array<std::string_view, 4> kTypeOf = {"decltype", "typeof", "__typeof__", "__typeof"};

constexpr std::array<std::string_view, 2> kVectorCasts = {"static_cast", "reinterpret_cast"};

class Casts {
 public:
  Casts(const std::vector<Token>& tokens, const Nesting& nesting, const VectorTypes& types, Language language,
        Edits& edits)
      : tokens_(tokens),
        nesting_(nesting),
        types_(types),
        parameters_(tokens, nesting),
        language_(language),
        edits_(edits) {}

  void edit() {
    for (std::size_t at = 0; at < tokens_.size(); ++at) {
      if (const auto type = cast_at(at)) {
        replace(at, nesting_.partner(at), type->name, operand_end(nesting_.partner(at) + 1));
      } else if (is_one_of(tokens_[at].text, kVectorCasts)) {
        edit_named_cast(at);
      } else if (const auto named = function_style_cast_at(at)) {
        edits_.replace(tokens_[at].begin, tokens_[named->end - 1].end(),
                       "spu_emu::cast< " + named->name + ">");
      }
    }
  }

 private:
  std::string_view text(std::size_t at) const {
    return at < tokens_.size() ? tokens_[at].text : std::string_view();
  }
  bool is_word(std::size_t at) const { return at < tokens_.size() && tokens_[at].kind == Token::Kind::word; }

  /// A vector type, or one that the compiler may find to be one: where it makes a function of a template, or
  /// knows the type of an operand.
  std::optional<VectorType> type_at(std::size_t at) const {
    if (auto type = types_.at(at)) return type;
    if (text(at) == "const") return type_at(at + 1);
    if (at < tokens_.size() && parameters_.is_one(at)) return VectorType{std::string(text(at)), at + 1};
    if (is_one_of(text(at), kTypeOf) && text(at + 1) == "(") {
      const std::size_t end = nesting_.partner(at + 1) + 1;
      return VectorType{source_between(tokens_[at].begin, tokens_[end - 1].end()), end};
    }
    if (text(at) != "typename") return std::nullopt;
    const std::size_t end = qualified_end(text(at + 1) == "::" ? at + 2 : at + 1);
    return VectorType{source_between(tokens_[at].begin, tokens_[end - 1].end()), end};
  }

  /// Behind `A::B<C>::D`, which begins at `at`.
  std::size_t qualified_end(std::size_t at) const {
    while (is_word(at)) {
      ++at;
      if (text(at) == "<") at = TemplateParameters::list_end(tokens_, nesting_, at) + 1;
      if (text(at) != "::") break;
      at += text(at + 1) == "template" ? 2 : 1;
    }
    return at;
  }

  /// As it stands in the source, which all tokens are parts of.
  std::string source_between(std::size_t begin, std::size_t end) const {
    const Token& first = tokens_.front();
    return {first.text.data() + (begin - first.begin), end - begin};
  }

  std::optional<VectorType> cast_at(std::size_t at) const {
    if (text(at) != "(" || !may_be_cast_after(at)) return std::nullopt;
    const auto type = type_at(at + 1);
    if (!type || type->end != nesting_.partner(at) || !begins_operand(type->end + 1)) return std::nullopt;
    return type;
  }

  /// Whether a parenthesis there is of an expression, not of a call or of parameters.
  bool may_be_cast_after(std::size_t at) const {
    if (at == 0) return false;
    const Token& before = tokens_[at - 1];
    if (before.kind == Token::Kind::word) return is_one_of(before.text, kBeforeExpressions);
    if (before.text == ")") return is_type_in_parentheses(nesting_.partner(at - 1));
    return before.kind == Token::Kind::mark && before.text != "]";
  }

  bool begins_operand(std::size_t at) const {
    if (at >= tokens_.size()) return false;
    if (tokens_[at].kind == Token::Kind::word) return !is_one_of(text(at), kAfterParameters);
    if (tokens_[at].kind != Token::Kind::mark) return true;
    return text(at) == "(" || text(at) == "::" || is_one_of(text(at), kPrefixes);
  }

  /// (vec_uint4), (unsigned int) and (anything *): a type, as far as tokens tell.
  bool is_type_in_parentheses(std::size_t open) const {
    const std::size_t close = nesting_.partner(open);
    if (close == open || close == open + 1) return false;
    const auto type = type_at(open + 1);
    if (type && (type->end == close || text(type->end) == "*")) return true;
    if (text(close - 1) == "*") return true;
    return std::all_of(tokens_.begin() + static_cast<std::ptrdiff_t>(open) + 1,
                       tokens_.begin() + static_cast<std::ptrdiff_t>(close), [](const Token& token) {
                         return is_type_word(token.text) || is_qualifier(token.text);
                       });
  }

  /// Behind the operand of a cast: a unary expression.
  std::size_t operand_end(std::size_t at) const {
    for (;;) {
      if (is_one_of(text(at), kPrefixes) || text(at) == "sizeof") {
        ++at;
      } else if (text(at) == "(" && is_type_in_parentheses(at) && text(nesting_.partner(at) + 1) != "{") {
        at = nesting_.partner(at) + 1;
      } else {
        return postfix_end(primary_end(at));
      }
    }
  }

  std::size_t primary_end(std::size_t at) const {
    if (text(at) == "(") {
      const std::size_t end = nesting_.partner(at) + 1;
      const bool is_literal = text(end) == "{" && is_type_in_parentheses(at);
      return is_literal ? nesting_.partner(end) + 1 : end;
    }
    if (text(at) == "::") ++at;
    const auto type = types_.at(at);
    if (type && text(type->end) == "{") return nesting_.partner(type->end) + 1;
    if (!is_word(at)) return at + 1;
    while (text(at + 1) == "::" && is_word(at + 2)) at += 2;
    return template_end(at + 1);
  }

  /// Behind the arguments of a template, if it is one that is called.
  std::size_t template_end(std::size_t at) const {
    if (text(at) != "<") return at;
    std::size_t end = at + 1;
    while (end < tokens_.size() &&
           (tokens_[end].kind == Token::Kind::word || tokens_[end].kind == Token::Kind::number ||
            text(end) == "::" || text(end) == "," || text(end) == "*")) {
      ++end;
    }
    return text(end) == ">" && text(end + 1) == "(" ? end + 1 : at;
  }

  std::size_t postfix_end(std::size_t at) const {
    for (;;) {
      if (text(at) == "(" || text(at) == "[") {
        at = nesting_.partner(at) + 1;
      } else if ((text(at) == "." || text(at) == "->") && is_word(at + 1)) {
        at += 2;
      } else if (text(at) == "++" || text(at) == "--") {
        ++at;
      } else {
        return at;
      }
    }
  }

  /// vec_uchar16(operand), where it can be no declaration.
  std::optional<VectorType> function_style_cast_at(std::size_t at) const {
    if (language_ != Language::cpp || at == 0 || !is_word(at) || text(at) == "const") return std::nullopt;
    const Token& before = tokens_[at - 1];
    const bool in_expression = before.text == "return" || is_one_of(before.text, kBeforeOperands);
    if (!in_expression) return std::nullopt;
    const auto type = type_at(at);
    if (!type || text(type->end) != "(") return std::nullopt;
    const std::size_t first = type->end + 1;
    const std::size_t close = nesting_.partner(type->end);
    if (close == first || (text(first) == "*" && first + 1 == close)) return std::nullopt;
    // vec_uchar16(vec_uint4) is the type of a function.
    const auto inner = type_at(first);
    if (inner && (inner->end == close || is_word(inner->end))) return std::nullopt;
    for (std::size_t i = first; i < close; i = std::max(i, nesting_.partner(i)) + 1) {
      if (text(i) == ",") return std::nullopt;
    }
    return type;
  }

  /// static_cast<vec_uchar16>(operand)
  void edit_named_cast(std::size_t at) {
    if (text(at + 1) != "<") return;
    const auto type = type_at(at + 2);
    if (!type || text(type->end) != ">" || text(type->end + 1) != "(") return;
    replace(at, type->end, type->name, nesting_.partner(type->end + 1) + 1);
  }

  /// Tokens first to last say the type; the operand lies between them and `end`.
  void replace(std::size_t first, std::size_t last, const std::string& type, std::size_t end) {
    const std::size_t behind = tokens_[end - 1].end();
    edits_.replace(tokens_[first].begin, tokens_[last].end(), call_to(type));
    edits_.insert(behind, ")");
  }

  /// In C a macro, which is read when this is done.
  std::string call_to(const std::string& type) const {
    if (language_ == Language::cpp) return "spu_emu::cast< " + type + ">(";
    const bool is_name = type.find('(') == std::string::npos;
    return is_name ? "spu_emu_cast_" + type + "(" : "spu_emu_cast_as(" + type + ", ";
  }

  const std::vector<Token>& tokens_;
  const Nesting& nesting_;
  const VectorTypes& types_;
  TemplateParameters parameters_;
  Language language_;
  Edits& edits_;
};

}  // namespace

void edit_casts(const std::vector<Token>& tokens, const Nesting& nesting, const VectorTypes& types,
                Language language, Edits& edits) {
  Casts(tokens, nesting, types, language, edits).edit();
}

}  // namespace spu_emu::compile
