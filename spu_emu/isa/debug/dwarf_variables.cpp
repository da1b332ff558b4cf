#include "isa/debug/dwarf_variables.h"

#include <map>

#include "mfc/command.h"

namespace spu_emu::isa {

namespace {

/// Where names mean something: the whole program, or the code of a function or a block.
struct Scope {
  std::uint32_t low = 0;
  std::uint32_t high = kLocalStoreSize;
};

class VariableReader {
 public:
  VariableReader(const Libdw& dw, Dwarf* dwarf) : dw_(dw), dwarf_(dwarf) {}

  Variables read() {
    variables_.types.emplace_back();
    Dwarf_Off at = 0;
    Dwarf_Off next = 0;
    std::size_t header = 0;
    while (dw_.dwarf_nextcu(dwarf_, at, &next, &header, nullptr, nullptr, nullptr) == 0) {
      Dwarf_Die unit{};
      if (dw_.dwarf_offdie(dwarf_, at + header, &unit) != nullptr) read_children(unit, Scope());
      at = next;
    }
    return std::move(variables_);
  }

 private:
  template <class Function>
  void for_children(Dwarf_Die& parent, Function function) {
    Dwarf_Die child{};
    if (dw_.dwarf_child(&parent, &child) != 0) return;
    do {
      function(child);
    } while (dw_.dwarf_siblingof(&child, &child) == 0);
  }

  void read_children(Dwarf_Die& parent, const Scope& scope) {
    for_children(parent, [&](Dwarf_Die& child) { read_entry(child, scope); });
  }

  void read_entry(Dwarf_Die& entry, const Scope& scope) {
    switch (dw_.dwarf_tag(&entry)) {
      case DW_TAG_namespace:
        return read_children(entry, scope);
      case DW_TAG_subprogram:
      case DW_TAG_lexical_block:
      case DW_TAG_inlined_subroutine:
        return read_children(entry, scope_of(entry, scope));
      case DW_TAG_variable:
      case DW_TAG_formal_parameter:
        return read_variable(entry, scope);
      default:
        return;
    }
  }

  /// A block in several pieces has the names of what is around it.
  Scope scope_of(Dwarf_Die& entry, const Scope& around) {
    Dwarf_Addr low = 0;
    Dwarf_Addr high = 0;
    if (dw_.dwarf_lowpc(&entry, &low) != 0 || dw_.dwarf_highpc(&entry, &high) != 0) return around;
    return {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(high)};
  }

  void read_variable(Dwarf_Die& entry, const Scope& scope) {
    Variable variable;
    const char* name = name_of(entry);
    Dwarf_Attribute location{};
    if (name == nullptr || dw_.dwarf_attr_integrate(&entry, DW_AT_location, &location) == nullptr) return;
    variable.name = name;
    variable.low = scope.low;
    variable.high = scope.high;
    Dwarf_Addr base = 0;
    Dwarf_Addr begin = 0;
    Dwarf_Addr end = 0;
    Dwarf_Op* operations = nullptr;
    std::size_t count = 0;
    for (std::ptrdiff_t at = 0;
         (at = dw_.dwarf_getlocations(&location, at, &base, &begin, &end, &operations, &count)) > 0;) {
      add_place(variable, begin, end, operations, count);
    }
    variable.type = type_of(entry);
    variables_.all.push_back(std::move(variable));
  }

  /// Places that are computed, or pieces of several, are left out.
  static void add_place(Variable& variable, Dwarf_Addr begin, Dwarf_Addr end, const Dwarf_Op* operations,
                        std::size_t count) {
    if (count != 1) return;
    const Dwarf_Op& operation = operations[0];
    VariablePlace place;
    if (operation.atom == DW_OP_addr) {
      place.kind = VariablePlace::Kind::address;
      place.value = static_cast<std::int32_t>(operation.number);
    } else if (operation.atom == DW_OP_fbreg) {
      place.kind = VariablePlace::Kind::frame;
      place.value = static_cast<std::int32_t>(operation.number);
    } else if (operation.atom >= DW_OP_reg0 && operation.atom <= DW_OP_reg31) {
      place.kind = VariablePlace::Kind::reg;
      place.value = operation.atom - DW_OP_reg0;
    } else if (operation.atom == DW_OP_regx && operation.number < 128) {
      place.kind = VariablePlace::Kind::reg;
      place.value = static_cast<std::int32_t>(operation.number);
    } else {
      return;
    }
    place.low = static_cast<std::uint32_t>(begin);
    place.high = end > kLocalStoreSize ? kLocalStoreSize : static_cast<std::uint32_t>(end);
    variable.places.push_back(place);
  }

  const char* name_of(Dwarf_Die& entry) {
    if (const char* name = dw_.dwarf_diename(&entry)) return name;
    Dwarf_Attribute origin{};
    Dwarf_Die original{};
    if (dw_.dwarf_attr_integrate(&entry, DW_AT_abstract_origin, &origin) == nullptr ||
        dw_.dwarf_formref_die(&origin, &original) == nullptr) {
      return nullptr;
    }
    return dw_.dwarf_diename(&original);
  }

  std::uint32_t type_of(Dwarf_Die& entry) {
    Dwarf_Attribute attribute{};
    Dwarf_Die named{};
    Dwarf_Die type{};
    if (dw_.dwarf_attr_integrate(&entry, DW_AT_type, &attribute) == nullptr ||
        dw_.dwarf_formref_die(&attribute, &named) == nullptr || dw_.dwarf_peel_type(&named, &type) != 0) {
      return 0;
    }
    const Dwarf_Off offset = dw_.dwarf_dieoffset(&type);
    const auto [place, is_new] =
        known_.try_emplace(offset, static_cast<std::uint32_t>(variables_.types.size()));
    const std::uint32_t number = place->second;
    if (!is_new) return number;
    // A type may refer to itself, so it has its number before it is read.
    variables_.types.emplace_back();
    VariableType read = read_type(type);
    variables_.types[number] = std::move(read);
    return number;
  }

  std::uint32_t number(Dwarf_Die& entry, unsigned what, std::uint32_t otherwise = 0) {
    Dwarf_Attribute attribute{};
    Dwarf_Word value = 0;
    if (dw_.dwarf_attr_integrate(&entry, what, &attribute) == nullptr ||
        dw_.dwarf_formudata(&attribute, &value) != 0) {
      return otherwise;
    }
    return static_cast<std::uint32_t>(value);
  }

  VariableType read_type(Dwarf_Die& entry) {
    VariableType type;
    if (const char* name = dw_.dwarf_diename(&entry)) type.name = name;
    type.size = number(entry, DW_AT_byte_size);
    switch (dw_.dwarf_tag(&entry)) {
      case DW_TAG_base_type:
        type.kind = kind_of_base(number(entry, DW_AT_encoding));
        break;
      case DW_TAG_pointer_type:
      case DW_TAG_reference_type:
        type.kind = VariableType::Kind::pointer;
        type.size = 4;
        type.target = type_of(entry);
        break;
      case DW_TAG_enumeration_type:
        type.kind = VariableType::Kind::enumeration;
        read_enumerators(entry, type);
        break;
      case DW_TAG_structure_type:
      case DW_TAG_class_type:
      case DW_TAG_union_type:
        type.kind = VariableType::Kind::structure;
        read_members(entry, type);
        break;
      case DW_TAG_array_type:
        read_array(entry, type);
        break;
      default:
        break;
    }
    return type;
  }

  static VariableType::Kind kind_of_base(std::uint32_t encoding) {
    switch (encoding) {
      case DW_ATE_signed:
        return VariableType::Kind::is_signed;
      case DW_ATE_unsigned:
      case DW_ATE_boolean:
        return VariableType::Kind::is_unsigned;
      case DW_ATE_signed_char:
      case DW_ATE_unsigned_char:
        return VariableType::Kind::character;
      case DW_ATE_float:
        return VariableType::Kind::floating;
      default:
        return VariableType::Kind::unknown;
    }
  }

  void read_members(Dwarf_Die& entry, VariableType& type) {
    for_children(entry, [&](Dwarf_Die& child) {
      const char* name = dw_.dwarf_diename(&child);
      Dwarf_Attribute bits{};
      const bool is_field = dw_.dwarf_attr(&child, DW_AT_bit_size, &bits) != nullptr;
      if (dw_.dwarf_tag(&child) != DW_TAG_member || is_field) return;
      type.members.push_back(
          {name == nullptr ? "" : name, number(child, DW_AT_data_member_location), type_of(child)});
    });
  }

  void read_enumerators(Dwarf_Die& entry, VariableType& type) {
    for_children(entry, [&](Dwarf_Die& child) {
      const char* name = dw_.dwarf_diename(&child);
      Dwarf_Attribute attribute{};
      Dwarf_Sword value = 0;
      if (name == nullptr || dw_.dwarf_attr(&child, DW_AT_const_value, &attribute) == nullptr ||
          dw_.dwarf_formsdata(&attribute, &value) != 0) {
        return;
      }
      type.enumerators.push_back({name, value});
    });
  }

  /// Of several dimensions the innermost is the one whose elements lie side by side.
  void read_array(Dwarf_Die& entry, VariableType& type) {
    std::vector<std::uint32_t> counts;
    for_children(entry, [&](Dwarf_Die& child) {
      if (dw_.dwarf_tag(&child) != DW_TAG_subrange_type) return;
      counts.push_back(number(child, DW_AT_count, number(child, DW_AT_upper_bound, ~0U) + 1));
    });
    type.kind = VariableType::Kind::array;
    type.target = type_of(entry);
    while (counts.size() > 1) {
      VariableType inner;
      inner.kind = VariableType::Kind::array;
      inner.target = type.target;
      inner.count = counts.back();
      inner.size = inner.count * variables_.types[type.target].size;
      type.target = static_cast<std::uint32_t>(variables_.types.size());
      variables_.types.push_back(std::move(inner));
      counts.pop_back();
    }
    type.count = counts.empty() ? 0 : counts.front();
    type.size = type.count * variables_.types[type.target].size;
  }

  const Libdw& dw_;
  Dwarf* dwarf_;
  std::map<Dwarf_Off, std::uint32_t> known_;
  Variables variables_;
};

}  // namespace

Variables read_variables(const Libdw& dw, Dwarf* dwarf) {
  return VariableReader(dw, dwarf).read();
}

}  // namespace spu_emu::isa
