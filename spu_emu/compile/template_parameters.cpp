#include "compile/template_parameters.h"

#include <algorithm>

namespace spu_emu::compile {

namespace {

/// Behind the declaration or definition that begins at `at`.
std::size_t declaration_end(const std::vector<Token>& tokens, const Nesting& nesting, std::size_t at) {
  for (; at < tokens.size(); ++at) {
    if (tokens[at].text == ";") return at + 1;
    if (tokens[at].text == "{") return nesting.partner(at) + 1;
    at = std::max(at, nesting.partner(at));
  }
  return tokens.size();
}

}  // namespace

std::size_t TemplateParameters::list_end(const std::vector<Token>& tokens, const Nesting& nesting,
                                         std::size_t at) {
  int open = 0;
  for (; at + 1 < tokens.size(); ++at) {
    if (tokens[at].text == "<") ++open;
    if (tokens[at].text == ">") --open;
    if (tokens[at].text == ">>") open -= 2;
    if (open <= 0) break;
    at = std::max(at, nesting.partner(at));
  }
  return at;
}

TemplateParameters::TemplateParameters(const std::vector<Token>& tokens, const Nesting& nesting)
    : tokens_(tokens) {
  for (std::size_t at = 0; at + 1 < tokens.size(); ++at) {
    if (tokens[at].text != "template" || tokens[at + 1].text != "<") continue;
    const std::size_t end = list_end(tokens, nesting, at + 1);
    const std::size_t reach = declaration_end(tokens, nesting, end);
    for (std::size_t i = at + 2; i < end; ++i) {
      const bool is_type = tokens[i - 1].text == "class" || tokens[i - 1].text == "typename";
      if (is_type && tokens[i].kind == Token::Kind::word) all_.push_back({tokens[i].text, end, reach});
    }
  }
}

bool TemplateParameters::is_one(std::size_t at) const {
  return std::any_of(all_.begin(), all_.end(), [&](const Parameter& each) {
    return at >= each.begin && at < each.end && tokens_[at].text == each.name;
  });
}

}  // namespace spu_emu::compile
