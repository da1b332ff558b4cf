/// @file
/// The variables of a program: their names, types and places, as its debug information has them.
#ifndef SPU_EMU_ISA_DEBUG_VARIABLES_H
#define SPU_EMU_ISA_DEBUG_VARIABLES_H

#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <vector>

namespace spu_emu::isa {

/// A member of a structure or a union: where in it, and of what type.
struct VariableMember {
  std::string name;
  std::uint32_t offset = 0;
  std::uint32_t type = 0;
};
struct Enumerator {
  std::string name;
  std::int64_t value = 0;
};

/// A type; others refer to it by its place among Variables::types.
struct VariableType {
  enum class Kind {
    unknown,
    is_signed,
    is_unsigned,
    character,
    floating,
    enumeration,
    pointer,
    array,
    structure
  };
  Kind kind = Kind::unknown;
  std::uint32_t size = 0;
  /// What a pointer leads to, what an array is of, and how many of these it has.
  std::uint32_t target = 0;
  std::uint32_t count = 0;
  std::string name;
  std::vector<VariableMember> members;
  std::vector<Enumerator> enumerators;
};

/// Where a variable is while the program stands in [low, high): at an address of the local store, at a
/// distance from the stack pointer of its function's caller, or in a register.
struct VariablePlace {
  enum class Kind { address, frame, reg };
  Kind kind = Kind::address;
  std::int32_t value = 0;
  std::uint32_t low = 0;
  std::uint32_t high = 0;
};

/// A variable, which its name means where the program stands in [low, high).
struct Variable {
  std::string name;
  std::uint32_t type = 0;
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  std::vector<VariablePlace> places;

  /// The one for `pc`; null where the program does not keep its value.
  const VariablePlace* place_at(std::uint32_t pc) const;
};

struct Variables {
  std::vector<VariableType> types;
  std::vector<Variable> all;

  /// The innermost variable of this name at `pc`; null if there is none.
  const Variable* find(std::string_view name, std::uint32_t pc) const;
  /// Those that names mean at `pc`.
  std::vector<std::string> names_at(std::uint32_t pc) const;
};

/// As text, which one program writes for another that cannot read DWARF, and back without what is broken.
std::string variable_table_text(const Variables& variables);
Variables read_variable_table(std::istream& text);

}  // namespace spu_emu::isa

#endif
