/// @file
/// Variables of functions at the addresses that the SPU's compiler gives them.
#ifndef SPU_EMU_COMPILE_LOCAL_VARIABLES_H
#define SPU_EMU_COMPILE_LOCAL_VARIABLES_H

#include "compile/edits.h"
#include "compile/tokens.h"

namespace spu_emu::compile {

/// A variable on the stack of an SPU lies at a multiple of 16, so transfers to and from it begin in the first
/// slot of a quadword. Declarations in blocks of code that begin with a built-in type, or with the name of a
/// type and that of a variable, get the attribute. Parameters, members and pointers to types with names do
/// not.
void align_local_variables(const std::vector<Token>& tokens, Edits& edits);

}  // namespace spu_emu::compile

#endif
