#include "compile/nesting.h"

namespace spu_emu::compile {

namespace {

bool is_linkage_brace(const std::vector<Token>& tokens, std::size_t at) {
  return tokens[at].text == "{" && at >= 2 && tokens[at - 1].kind == Token::Kind::text &&
         tokens[at - 2].text == "extern";
}

bool opens(std::string_view mark) {
  return mark == "(" || mark == "[" || mark == "{";
}
bool closes(std::string_view mark, std::string_view opened) {
  return (opened == "(" && mark == ")") || (opened == "[" && mark == "]") || (opened == "{" && mark == "}");
}

}  // namespace

Nesting::Nesting(const std::vector<Token>& tokens) : partner_(tokens.size()), depth_(tokens.size()) {
  std::vector<std::size_t> open;
  unsigned depth = 0;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    partner_[at] = at;
    const std::string_view mark = tokens[at].text;
    if (tokens[at].kind == Token::Kind::mark && !open.empty() && closes(mark, tokens[open.back()].text)) {
      partner_[at] = open.back();
      partner_[open.back()] = at;
      if (mark == "}" && !is_linkage_brace(tokens, open.back())) --depth;
      open.pop_back();
    }
    depth_[at] = depth;
    if (tokens[at].kind == Token::Kind::mark && opens(mark)) {
      open.push_back(at);
      if (mark == "{" && !is_linkage_brace(tokens, at)) ++depth;
    }
  }
}

}  // namespace spu_emu::compile
