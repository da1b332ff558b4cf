/// @file
/// Variables of the program as values: what an expression like list->items[2].count means, and its text.
#ifndef SPU_EMU_ISA_DEBUG_VARIABLE_VALUE_H
#define SPU_EMU_ISA_DEBUG_VARIABLE_VALUE_H

#include <string>
#include <string_view>
#include <vector>

#include "isa/debug/session.h"

namespace spu_emu::isa {

/// Bytes of a type: in the local store at `at`, or in register `at` from its byte `offset` on.
struct VariableValue {
  std::uint32_t type = 0;
  bool in_register = false;
  std::uint32_t at = 0;
  std::uint32_t offset = 0;
};

/// NAME, behind it any of .MEMBER, ->MEMBER and [NUMBER], before it any of *. Throws CommandError.
VariableValue find_value(const Session& session, std::string_view expression);
/// Whether the expression has that form and a variable has its name, where the program stands.
bool is_variable(const Session& session, std::string_view expression);

std::vector<std::byte> value_bytes(const Session& session, const VariableValue& value);
/// As C would write it: numbers, {1, 2}, {count = 3}, "text", an enumerator's name.
std::string value_text(const Session& session, const VariableValue& value);

}  // namespace spu_emu::isa

#endif
