#include "compile/translate.h"

#include "compile/casts.h"
#include "compile/edits.h"
#include "compile/main_function.h"
#include "compile/nesting.h"
#include "compile/tokens.h"
#include "compile/vector_types.h"

namespace spu_emu::compile {

namespace {

/// `vector unsigned int` becomes the attribute before the type. `__vector` before another name is the
/// attribute, too.
void edit_keywords(const std::vector<Token>& tokens, Edits& edits) {
  static constexpr const char* kAttribute = "__attribute__((__vector_size__(16)))";
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (const auto keyword = vector_keyword(tokens, at)) {
      edits.replace(tokens[at].begin, tokens[at].end(), kAttribute);
      edits.replace(tokens[keyword->first].begin, tokens[keyword->end - 1].end(), keyword->element);
    } else if (tokens[at].text == "__vector") {
      edits.replace(tokens[at].begin, tokens[at].end(), kAttribute);
    }
  }
}

}  // namespace

std::string translate(std::string_view source, Language language) {
  const std::vector<Token> tokens = tokens_of(source);
  const Nesting nesting(tokens);
  const VectorTypes types(tokens);
  Edits edits;
  edit_casts(tokens, nesting, types, language, edits);
  edit_main(tokens, nesting, language, source.size(), edits);
  edit_keywords(tokens, edits);
  return edits.apply(source);
}

}  // namespace spu_emu::compile
