/// @file
/// The words and marks of a preprocessed source, without those of system headers.
#ifndef SPU_EMU_COMPILE_TOKENS_H
#define SPU_EMU_COMPILE_TOKENS_H

#include <cstddef>
#include <string_view>
#include <vector>

namespace spu_emu::compile {

struct Token {
  enum class Kind { word, number, text, mark };
  Kind kind = Kind::mark;
  /// Where in the source it begins; `text` is a part of it.
  std::size_t begin = 0;
  std::string_view text;

  std::size_t end() const { return begin + text.size(); }
};

/// `source` is what a preprocessor wrote: no comments, and lines `# number "file" flags` that say where text
/// comes from. What is flagged as of a system header is left out, and so are lines that begin with #.
std::vector<Token> tokens_of(std::string_view source);

}  // namespace spu_emu::compile

#endif
