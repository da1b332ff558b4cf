#include "compile/vector_types.h"

#include <algorithm>
#include <array>

namespace spu_emu::compile {

namespace {

using Words = std::vector<std::string_view>;

bool is_one_of(std::string_view word, const auto& words) {
  return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

std::size_t count(const Words& words, std::string_view word) {
  return static_cast<std::size_t>(std::count(words.begin(), words.end(), word));
}

/// The vector of `bool` and of pixels is one of unsigned integers on an SPU.
std::string element_of(const Words& words) {
  const bool is_bool = count(words, "bool") + count(words, "_Bool") + count(words, "__bool") != 0;
  const bool is_pixel = count(words, "pixel") + count(words, "__pixel") != 0;
  if (is_pixel) return "unsigned short";
  std::string text;
  if (is_bool) text = "unsigned ";
  for (const std::string_view word : words) {
    if (word == "bool" || word == "_Bool" || word == "__bool") continue;
    text += std::string(word) + " ";
  }
  text.pop_back();
  return text;
}

/// The SDK's name for a vector of `element`.
std::string name_of(const std::string& element) {
  Words words;
  for (std::size_t at = 0; at < element.size();) {
    const std::size_t end = std::min(element.find(' ', at), element.size());
    words.push_back(std::string_view(element).substr(at, end - at));
    at = end + 1;
  }
  const std::string sign = count(words, "unsigned") != 0 ? "u" : "";
  if (count(words, "float") != 0) return "vec_float4";
  if (count(words, "double") != 0) return "vec_double2";
  if (count(words, "char") != 0)
    return "vec_" + std::string(count(words, "signed") != 0 ? "" : "u") + "char16";
  if (count(words, "short") != 0) return "vec_" + sign + "short8";
  if (count(words, "long") != 0) return "vec_" + sign + "llong2";
  return "vec_" + sign + "int4";
}

constexpr std::array<std::string_view, 14> kNames = {
    "vec_uchar16", "vec_char16", "vec_ushort8", "vec_short8", "vec_uint4",   "vec_int4",    "vec_ullong2",
    "vec_llong2",  "vec_float4", "vec_double2", "qword",      "vec_bchar16", "vec_bshort8", "vec_bint4"};

}  // namespace

bool is_qualifier(std::string_view word) {
  return word == "const" || word == "volatile" || word == "__const" || word == "__volatile__";
}

bool is_type_word(std::string_view word) {
  static constexpr std::array<std::string_view, 14> kWords = {
      "unsigned", "signed", "char",  "short",  "int",     "long", "float",
      "double",   "bool",   "_Bool", "__bool", "__pixel", "void", "__signed__"};
  return is_one_of(word, kWords);
}

std::optional<VectorKeyword> vector_keyword(const std::vector<Token>& tokens, std::size_t at) {
  if (tokens[at].text != "vector" && tokens[at].text != "__vector") return std::nullopt;
  VectorKeyword found;
  std::size_t next = at + 1;
  while (next < tokens.size() && is_qualifier(tokens[next].text)) ++next;
  found.first = next;
  Words words;
  while (next < tokens.size()) {
    const std::string_view word = tokens[next].text;
    const bool is_pixel = word == "pixel" && words.empty();
    if ((!is_type_word(word) || word == "void") && !is_pixel) break;
    words.push_back(word == "__signed__" ? "signed" : word);
    ++next;
  }
  if (words.empty()) return std::nullopt;
  found.end = next;
  found.element = element_of(words);
  found.name = name_of(found.element);
  return found;
}

VectorTypes::VectorTypes(const std::vector<Token>& tokens) : tokens_(tokens) {
  for (const std::string_view name : kNames) names_[std::string(name)] = std::string(name);
  names_["vec_bchar16"] = "vec_uchar16";
  names_["vec_bshort8"] = names_["vec_pixel8"] = "vec_ushort8";
  names_["vec_bint4"] = "vec_uint4";
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (tokens[at].text == "typedef") learn_typedef(at);
    if (tokens[at].text == "using") learn_alias(at);
  }
}

std::optional<VectorType> VectorTypes::at(std::size_t at) const {
  while (at < tokens_.size() && is_qualifier(tokens_[at].text)) ++at;
  if (at >= tokens_.size() || tokens_[at].kind != Token::Kind::word) return std::nullopt;
  VectorType type;
  if (const auto keyword = vector_keyword(tokens_, at)) {
    type = {keyword->name, keyword->end};
  } else if (const auto found = names_.find(tokens_[at].text); found != names_.end()) {
    type = {found->second, at + 1};
  } else {
    return std::nullopt;
  }
  while (type.end < tokens_.size() && is_qualifier(tokens_[type.end].text)) ++type.end;
  return type;
}

/// `typedef TYPE one, two;`: what else a typedef may make of the type is no vector.
void VectorTypes::learn_typedef(std::size_t at) {
  const auto type = this->at(at + 1);
  if (!type) return;
  for (std::size_t next = type->end; next + 1 < tokens_.size(); next += 2) {
    const std::string_view mark = tokens_[next + 1].text;
    if (tokens_[next].kind != Token::Kind::word || (mark != "," && mark != ";")) return;
    names_[std::string(tokens_[next].text)] = type->name;
    if (mark == ";") return;
  }
}

void VectorTypes::learn_alias(std::size_t at) {
  if (at + 3 >= tokens_.size() || tokens_[at + 2].text != "=") return;
  const auto type = this->at(at + 3);
  if (!type || type->end >= tokens_.size() || tokens_[type->end].text != ";") return;
  names_[std::string(tokens_[at + 1].text)] = type->name;
}

}  // namespace spu_emu::compile
