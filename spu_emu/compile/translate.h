/// @file
/// Makes of an SPU source what a compiler of this machine understands as the SPU's would.
#ifndef SPU_EMU_COMPILE_TRANSLATE_H
#define SPU_EMU_COMPILE_TRANSLATE_H

#include <string>
#include <string_view>

namespace spu_emu::compile {

enum class Language { c, cpp };

/// `source` is preprocessed. In the result
/// - `vector` before a built-in type is an attribute, and a name like others elsewhere,
/// - a cast between vectors moves bytes as a cast on the SPU does, whatever the widths of their elements,
/// - main has a name and a linkage by which the program's entry finds it, whatever its parameters, and
/// returns
///   0 where it returns nothing,
/// - in C, an argument with braces stands in parentheses, so that a macro takes it for one.
/// Lines stay where they are.
std::string translate(std::string_view source, Language language);

}  // namespace spu_emu::compile

#endif
