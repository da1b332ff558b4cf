#include "isa/debug/variable_value.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "isa/debug/store_reader.h"
#include "isa/debug/value_format.h"
#include "isa/encoding/big_endian.h"
#include "mfc/format.h"

namespace spu_emu::isa {

namespace {
using TypeKind = VariableType::Kind;
using Bytes = std::span<const std::byte>;

constexpr std::uint32_t kRegisterBytes = 16;
constexpr std::uint32_t kMostShown = 64;
constexpr unsigned kDeepest = 8;

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == ':';
}

std::string_view take_name(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_name_character);
  const auto size = static_cast<std::size_t>(end - text.begin());
  const std::string_view name = text.substr(0, size);
  text.remove_prefix(size);
  return name;
}

std::string in_quotes(std::string_view text) {
  return '"' + std::string(text) + '"';
}

[[noreturn]] void fail_unknown(const Session& session, std::string_view name) {
  if (session.variables.all.empty()) {
    throw CommandError("Variables are not known: " + (session.no_lines.empty()
                                                          ? "the program was compiled without -g."
                                                          : session.no_lines));
  }
  const std::string nearest = nearest_name(name, session.variables.names_at(session.machine.pc()));
  throw CommandError("No variable " + in_quotes(name) + " is known here" +
                     (nearest.empty() ? "." : "; the nearest is " + nearest + "."));
}

/// Small numbers stand at the end of the preferred word.
VariableValue in_register(const VariableType& type, std::uint32_t number, std::uint32_t reg) {
  return {number, true, reg, type.size < 4 ? 4 - type.size : 0};
}

VariableValue place_value(const Session& session, const Variable& variable) {
  const VariablePlace* place = variable.place_at(session.machine.pc());
  if (place == nullptr)
    throw CommandError("The compiler keeps no value of " + in_quotes(variable.name) +
                       " where the program stands.");
  const VariableType& type = session.variables.types[variable.type];
  const auto number = static_cast<std::uint32_t>(place->value);
  if (place->kind == VariablePlace::Kind::reg) return in_register(type, variable.type, number);
  if (place->kind == VariablePlace::Kind::address) return {variable.type, false, number, 0};
  return {variable.type, false, session.frames().front().caller_sp + number, 0};
}

VariableValue followed(const Session& session, const VariableValue& pointer) {
  const VariableType& type = session.variables.types[pointer.type];
  if (type.kind == TypeKind::array) return {type.target, pointer.in_register, pointer.at, pointer.offset};
  if (type.kind != TypeKind::pointer) throw CommandError("Only a pointer or an array can be followed.");
  const std::vector<std::byte> bytes = value_bytes(session, pointer);
  if (bytes.size() != sizeof(std::uint32_t)) throw CommandError("This pointer has not the size of one.");
  return {type.target, false, read_word(bytes.data()), 0};
}

VariableValue member_of(const Session& session, const VariableValue& value, std::string_view name) {
  const VariableType& type = session.variables.types[value.type];
  for (const VariableMember& member : type.members) {
    if (member.name != name) continue;
    if (value.in_register) return {member.type, true, value.at, value.offset + member.offset};
    return {member.type, false, value.at + member.offset, 0};
  }
  std::string names;
  for (const VariableMember& member : type.members) names += (names.empty() ? " " : ", ") + member.name;
  throw CommandError("There is no member " + in_quotes(name) +
                     (names.empty() ? ": it is no structure." : "; there are:" + names + "."));
}

VariableValue element_of(const Session& session, const VariableValue& value, std::uint32_t index) {
  const VariableType& type = session.variables.types[value.type];
  if (type.kind == TypeKind::array && index >= type.count && type.count != 0)
    throw CommandError(format("There is no element %u: they are 0 to %u.", index, type.count - 1));
  VariableValue element = followed(session, value);
  const std::uint32_t distance = index * session.variables.types[element.type].size;
  (element.in_register ? element.offset : element.at) += distance;
  return element;
}

VariableValue take_suffix(const Session& session, VariableValue value, std::string_view& rest) {
  if (rest.starts_with("->")) {
    rest.remove_prefix(2);
    return member_of(session, followed(session, value), take_name(rest));
  }
  if (rest.starts_with('.')) {
    rest.remove_prefix(1);
    return member_of(session, value, take_name(rest));
  }
  const std::size_t close = rest.find(']');
  if (!rest.starts_with('[') || close == std::string_view::npos)
    throw CommandError(in_quotes(rest) + " is neither .MEMBER nor ->MEMBER nor [NUMBER].");
  const std::string_view inside = rest.substr(1, close - 1);
  rest.remove_prefix(close + 1);
  return element_of(session, value, number_in(inside));
}

std::uint64_t whole(Bytes bytes) {
  std::uint64_t value = 0;
  for (const std::byte each : bytes) value = value << 8U | std::to_integer<std::uint64_t>(each);
  return value;
}
std::int64_t signed_whole(Bytes bytes) {
  if (bytes.empty()) return 0;
  const auto unused = static_cast<unsigned>(64 - 8 * std::min<std::size_t>(bytes.size(), 8));
  return static_cast<std::int64_t>(whole(bytes) << unused) >> unused;
}

std::string left_aligned(std::string text) {
  text.erase(0, text.find_first_not_of(' '));
  return text;
}

class ValueWriter {
 public:
  explicit ValueWriter(const Variables& variables) : variables_(variables) {}

  std::string text(std::uint32_t number, Bytes bytes, unsigned depth = 0) const {
    const VariableType& type = variables_.types[number];
    if (bytes.size() < type.size || depth > kDeepest) return "...";
    bytes = bytes.first(type.size);
    switch (type.kind) {
      case TypeKind::is_signed:
        return format("%lld", static_cast<long long>(signed_whole(bytes)));
      case TypeKind::is_unsigned:
        return format("%llu", static_cast<unsigned long long>(whole(bytes)));
      case TypeKind::character:
        return character(bytes.empty() ? std::byte{} : bytes[0]);
      case TypeKind::floating:
        return left_aligned(format_elements(*find_format(type.size == 4 ? "float4" : "double2"), bytes));
      case TypeKind::enumeration:
        return enumerator(type, bytes);
      case TypeKind::pointer:
        return format("0x%05llx", static_cast<unsigned long long>(whole(bytes)));
      case TypeKind::array:
        return array(type, bytes, depth);
      case TypeKind::structure:
        return structure(type, bytes, depth);
      default:
        return bytes.empty() ? "(its type is not known)"
                             : left_aligned(format_elements(*find_format("x16"), bytes));
    }
  }

 private:
  static std::string character(std::byte byte) {
    const auto c = std::to_integer<unsigned char>(byte);
    return c >= 0x20 && c < 0x7f ? format("%u '%c'", c, c) : format("%u", c);
  }

  static std::string enumerator(const VariableType& type, Bytes bytes) {
    for (const Enumerator& each : type.enumerators) {
      if (each.value == signed_whole(bytes)) return each.name;
    }
    return format("%lld", static_cast<long long>(signed_whole(bytes)));
  }

  std::string array(const VariableType& type, Bytes bytes, unsigned depth) const {
    const VariableType& element = variables_.types[type.target];
    if (element.kind == TypeKind::character) return string(bytes);
    std::string all;
    for (std::uint32_t i = 0; i < std::min(type.count, kMostShown); ++i) {
      const std::size_t at = std::size_t{i} * element.size;
      if (at > bytes.size()) return "...";
      all += (i == 0 ? "" : ", ") + text(type.target, bytes.subspan(at), depth + 1);
    }
    return "{" + all + (type.count > kMostShown ? ", ...}" : "}");
  }

  /// Up to the NUL that ends it.
  static std::string string(Bytes bytes) {
    const auto end = std::find(bytes.begin(), bytes.end(), std::byte{0});
    return '"' + format_characters(bytes.first(static_cast<std::size_t>(end - bytes.begin()))) + '"';
  }

  std::string structure(const VariableType& type, Bytes bytes, unsigned depth) const {
    std::string all;
    for (const VariableMember& member : type.members) {
      if (member.offset > bytes.size()) continue;
      all += (all.empty() ? "" : ", ") + (member.name.empty() ? "" : member.name + " = ") +
             text(member.type, bytes.subspan(member.offset), depth + 1);
    }
    return "{" + all + "}";
  }

  const Variables& variables_;
};

}  // namespace

bool is_variable(const Session& session, std::string_view expression) {
  expression.remove_prefix(std::min(expression.find_first_not_of('*'), expression.size()));
  const Variable* variable = session.variables.find(take_name(expression), session.machine.pc());
  const bool ends_so = expression.empty() || expression.starts_with('.') || expression.starts_with('[') ||
                       expression.starts_with("->");
  return variable != nullptr && ends_so;
}

VariableValue find_value(const Session& session, std::string_view expression) {
  std::string_view rest = expression;
  rest.remove_prefix(std::min(rest.find_first_not_of('*'), rest.size()));
  std::size_t stars = expression.size() - rest.size();
  const std::string_view name = take_name(rest);
  const Variable* variable = session.variables.find(name, session.machine.pc());
  if (variable == nullptr) fail_unknown(session, name);
  VariableValue value = place_value(session, *variable);
  while (!rest.empty()) value = take_suffix(session, value, rest);
  for (; stars != 0; --stars) value = followed(session, value);
  return value;
}

std::vector<std::byte> value_bytes(const Session& session, const VariableValue& value) {
  const std::uint32_t size = session.variables.types[value.type].size;
  if (!value.in_register) {
    check_bytes(value.at, size);
    return read_store(session.store, value.at, size);
  }
  std::array<std::byte, kRegisterBytes> bytes{};
  for (unsigned slot = 0; slot < 4; ++slot)
    write_word(&bytes[4 * slot], session.machine.word(value.at, slot));
  if (value.offset + std::uint64_t{size} > kRegisterBytes)
    throw CommandError("The value is in several registers; registers shows them.");
  return {bytes.begin() + value.offset, bytes.begin() + value.offset + size};
}

std::string value_text(const Session& session, const VariableValue& value) {
  return ValueWriter(session.variables).text(value.type, value_bytes(session, value));
}

}  // namespace spu_emu::isa
