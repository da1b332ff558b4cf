/// @file
/// Names that are types in a template: what they stand for only the compiler knows.
#ifndef SPU_EMU_COMPILE_TEMPLATE_PARAMETERS_H
#define SPU_EMU_COMPILE_TEMPLATE_PARAMETERS_H

#include <cstddef>
#include <string_view>
#include <vector>

#include "compile/nesting.h"

namespace spu_emu::compile {

class TemplateParameters {
 public:
  /// Finds `template <class V, typename W>` and how far each template reaches.
  TemplateParameters(const std::vector<Token>& tokens, const Nesting& nesting);

  /// The > of the < at `at`; in lists of parameters and arguments nothing is compared.
  static std::size_t list_end(const std::vector<Token>& tokens, const Nesting& nesting, std::size_t at);

  /// Whether the word at `at` is a type parameter of a template around it.
  bool is_one(std::size_t at) const;

 private:
  struct Parameter {
    std::string_view name;
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  const std::vector<Token>& tokens_;
  std::vector<Parameter> all_;
};

}  // namespace spu_emu::compile

#endif
