/// @file
/// A compiler's command line, taken apart into those of its stages.
#ifndef SPU_EMU_COMPILE_COMMAND_LINE_H
#define SPU_EMU_COMPILE_COMMAND_LINE_H

#include <optional>
#include <string>
#include <vector>

#include "compile/translate.h"

namespace spu_emu::compile {

using Words = std::vector<std::string>;

/// `COMPILER OPTION... -o OBJECT -c SOURCE`. A source that ends in .c is C whatever the compiler's name says:
/// options that are for C++ only are left out, and -std= of C++ gives place to C11 with what old sources rely
/// on, unless a later -std= names another C.
class CommandLine {
 public:
  /// Nothing if the words compile no single source.
  static std::optional<CommandLine> of(const Words& words);

  Language language() const { return language_; }
  const std::string& object() const { return object_; }

  /// From the source to preprocessed text, with the list of what it depends on.
  Words preprocess(const std::string& text) const;
  /// From translated text. `has_macros` brings the intrinsics' macros for C in, in another round of the
  /// preprocessor.
  Words to_assembly(const std::string& text, const std::string& assembly, bool has_macros) const;
  Words assemble(const std::string& assembly) const;

 private:
  void take_c_options();

  std::string compiler_;
  Words options_;
  std::string source_;
  std::string object_;
  Language language_ = Language::cpp;
};

}  // namespace spu_emu::compile

#endif
