#include "compile/translate.h"

#include <algorithm>

#include "compile/casts.h"
#include "compile/edits.h"
#include "compile/local_variables.h"
#include "compile/main_function.h"
#include "compile/nesting.h"
#include "compile/tokens.h"
#include "compile/vector_types.h"

namespace spu_emu::compile {

namespace {

/// `vector unsigned int` becomes the SDK's name of the type; in a source that has not read it, the type with
/// the attribute. `__vector` before a name that is not built in is the attribute, too.
void edit_keywords(const std::vector<Token>& tokens, bool has_names, Edits& edits) {
  static const std::string kAttribute = "__attribute__((__vector_size__(16)))";
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (const auto keyword = vector_keyword(tokens, at)) {
      const std::string type = has_names ? keyword->name : keyword->element + " " + kAttribute;
      edits.replace(tokens[at].begin, tokens[at].end(), "");
      edits.replace(tokens[keyword->first].begin, tokens[keyword->end - 1].end(), type);
    } else if (tokens[at].text == "__vector") {
      edits.replace(tokens[at].begin, tokens[at].end(), kAttribute);
    }
  }
}

/// Puts the argument between tokens `begin` and `end` in parentheses if it has braces outside of some.
void edit_argument(const std::vector<Token>& tokens, const Nesting& nesting, std::size_t begin,
                   std::size_t end, Edits& edits) {
  for (std::size_t at = begin; at < end; ++at) {
    if (tokens[at].text == "{") {
      edits.insert(tokens[begin].begin, "(");
      edits.insert(tokens[end - 1].end(), ")");
      return;
    }
    at = std::max(at, nesting.partner(at));
  }
}

/// `f(a, (vec_int4){1, 2, 3, 4})`: the commas in braces part no arguments of a function, but those of a
/// macro.
void edit_arguments(const std::vector<Token>& tokens, const Nesting& nesting, Edits& edits) {
  for (std::size_t open = 1; open < tokens.size(); ++open) {
    if (tokens[open].text != "(" || tokens[open - 1].kind != Token::Kind::word) continue;
    const std::size_t close = nesting.partner(open);
    std::size_t begin = open + 1;
    for (std::size_t at = begin; at <= close; ++at) {
      if (at == close || tokens[at].text == ",") {
        edit_argument(tokens, nesting, begin, at, edits);
        begin = at + 1;
      } else {
        at = std::max(at, nesting.partner(at));
      }
    }
  }
}

}  // namespace

std::string translate(std::string_view source, Language language) {
  const std::vector<Token> tokens = tokens_of(source);
  const Nesting nesting(tokens);
  const VectorTypes types(tokens);
  Edits edits;
  align_local_variables(tokens, edits);
  if (language == Language::c) edit_arguments(tokens, nesting, edits);
  edit_casts(tokens, nesting, types, language, edits);
  edit_main(tokens, nesting, language, source.size(), edits);
  edit_keywords(tokens, source.find(" vec_uchar16;") != std::string_view::npos, edits);
  return edits.apply(source);
}

}  // namespace spu_emu::compile
