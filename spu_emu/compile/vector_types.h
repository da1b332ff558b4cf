/// @file
/// How source names vector types: the SDK's names, `vector` before a built-in type, and typedefs of either.
#ifndef SPU_EMU_COMPILE_VECTOR_TYPES_H
#define SPU_EMU_COMPILE_VECTOR_TYPES_H

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compile/tokens.h"

namespace spu_emu::compile {

/// `name` is the SDK's name of the type, such as vec_uint4, or qword; `end` is behind its last token.
struct VectorType {
  std::string name;
  std::size_t end = 0;
};

/// Where `vector` or `__vector` is the keyword: the built-in type behind it, as tokens [first, end).
struct VectorKeyword {
  std::size_t first = 0;
  std::size_t end = 0;
  /// The scalar type that is meant, as C has it: of `bool int` it is unsigned int. And the vector's name.
  std::string element;
  std::string name;
};

bool is_qualifier(std::string_view word);
/// Part of the name of a built-in type.
bool is_type_word(std::string_view word);

/// The keyword at `at`; nothing where the word names a variable, a member or std::vector.
std::optional<VectorKeyword> vector_keyword(const std::vector<Token>& tokens, std::size_t at);

class VectorTypes {
 public:
  /// Learns the typedefs and aliases of `tokens`.
  explicit VectorTypes(const std::vector<Token>& tokens);

  /// The vector type, with qualifiers on both sides, that begins at `at`.
  std::optional<VectorType> at(std::size_t at) const;

 private:
  void learn_typedef(std::size_t at);
  void learn_alias(std::size_t at);

  const std::vector<Token>& tokens_;
  std::map<std::string, std::string, std::less<>> names_;
};

}  // namespace spu_emu::compile

#endif
