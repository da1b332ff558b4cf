#include "compile/main_function.h"

namespace spu_emu::compile {

namespace {

class MainFunction {
 public:
  MainFunction(const std::vector<Token>& tokens, const Nesting& nesting, Language language, Edits& edits)
      : tokens_(tokens), nesting_(nesting), language_(language), edits_(edits) {}

  void edit(std::size_t end) {
    for (std::size_t at = 0; at + 1 < tokens_.size(); ++at) {
      if (tokens_[at].text != "main" || tokens_[at + 1].text != "(" || is_member(at)) continue;
      edits_.replace(tokens_[at].begin, tokens_[at].end(), "spu_emu_program_main");
      if (nesting_.depth(at) == 0) edit_declaration(at);
    }
    if (returns_nothing_) edits_.insert(end, note_of_nothing(language_));
  }

 private:
  static const char* note_of_nothing(Language language) {
    return language == Language::c ? "\nconst char spu_emu_program_main_is_void = 1;\n"
                                   : "\nextern \"C\" {\nextern const char spu_emu_program_main_is_void;\n"
                                     "const char spu_emu_program_main_is_void = 1;\n}\n";
  }

  bool is_member(std::size_t at) const {
    if (at == 0) return false;
    const std::string_view before = tokens_[at - 1].text;
    return before == "." || before == "->" || before == "::";
  }

  void edit_declaration(std::size_t at) {
    std::size_t first = at;
    while (first > 0 && tokens_[first - 1].text != ";" && tokens_[first - 1].text != "}" &&
           tokens_[first - 1].text != "{") {
      --first;
    }
    const bool has_linkage = tokens_[first].text == "extern" && tokens_[first + 1].kind == Token::Kind::text;
    if (language_ == Language::cpp && !has_linkage) edits_.insert(tokens_[first].begin, "extern \"C\" ");
    std::size_t body = nesting_.partner(at + 1) + 1;
    if (body >= tokens_.size() || tokens_[body].text == ";") return;
    while (body < tokens_.size() && tokens_[body].text != "{") ++body;
    if (body == tokens_.size()) return;
    if (at > 0 && tokens_[at - 1].text == "void") {
      returns_nothing_ = true;
    } else {
      edits_.insert(tokens_[nesting_.partner(body)].begin, "return 0;");
    }
  }

  const std::vector<Token>& tokens_;
  const Nesting& nesting_;
  Language language_;
  Edits& edits_;
  bool returns_nothing_ = false;
};

}  // namespace

void edit_main(const std::vector<Token>& tokens, const Nesting& nesting, Language language, std::size_t end,
               Edits& edits) {
  MainFunction(tokens, nesting, language, edits).edit(end);
}

}  // namespace spu_emu::compile
