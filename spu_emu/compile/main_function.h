/// @file
/// The program's main, under a name that its module's entry calls.
#ifndef SPU_EMU_COMPILE_MAIN_FUNCTION_H
#define SPU_EMU_COMPILE_MAIN_FUNCTION_H

#include "compile/edits.h"
#include "compile/nesting.h"
#include "compile/tokens.h"
#include "compile/translate.h"

namespace spu_emu::compile {

/// `end` is the size of the source, behind which it may write.
void edit_main(const std::vector<Token>& tokens, const Nesting& nesting, Language language, std::size_t end,
               Edits& edits);

}  // namespace spu_emu::compile

#endif
