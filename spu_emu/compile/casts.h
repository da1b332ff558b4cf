/// @file
/// Casts between vectors, in source that a little-endian machine compiles.
#ifndef SPU_EMU_COMPILE_CASTS_H
#define SPU_EMU_COMPILE_CASTS_H

#include "compile/edits.h"
#include "compile/nesting.h"
#include "compile/tokens.h"
#include "compile/translate.h"
#include "compile/vector_types.h"

namespace spu_emu::compile {

/// Each `(vec_uchar16)operand`, and static_cast and reinterpret_cast, becomes a call of a function that
/// reorders bytes where the widths of the elements differ. To what is no vector the functions are plain
/// casts.
void edit_casts(const std::vector<Token>& tokens, const Nesting& nesting, const VectorTypes& types,
                Language language, Edits& edits);

}  // namespace spu_emu::compile

#endif
