#include "isa/debug/value_format.h"

#include <bit>
#include <cmath>
#include <cstdint>

#include "isa/encoding/big_endian.h"
#include "mfc/format.h"

namespace spu_emu::isa {

namespace {
using Kind = ValueFormat::Kind;

constexpr ValueFormat kFormats[] = {
    {"x4", Kind::hexadecimal, 4},      {"x1", Kind::hexadecimal, 16},   {"x2", Kind::hexadecimal, 8},
    {"x8", Kind::hexadecimal, 2},      {"x16", Kind::hexadecimal, 1},   {"char16", Kind::is_signed, 1},
    {"uchar16", Kind::is_unsigned, 1}, {"short8", Kind::is_signed, 2},  {"ushort8", Kind::is_unsigned, 2},
    {"int4", Kind::is_signed, 4},      {"uint4", Kind::is_unsigned, 4}, {"llong2", Kind::is_signed, 8},
    {"ullong2", Kind::is_unsigned, 8}, {"float4", Kind::floating, 4},   {"double2", Kind::floating, 8},
};

std::uint64_t unsigned_value(std::span<const std::byte> bytes) {
  std::uint64_t value = 0;
  for (const std::byte each : bytes) value = (value << 8U) | std::to_integer<std::uint64_t>(each);
  return value;
}

std::int64_t signed_value(std::span<const std::byte> bytes) {
  const auto unused = static_cast<unsigned>(64 - 8 * bytes.size());
  return static_cast<std::int64_t>(unsigned_value(bytes) << unused) >> unused;
}

/// An SPU's single precision has neither infinities nor denormals: its largest exponent is one like the
/// others.
double single_value(std::uint32_t bits) {
  const auto exponent = static_cast<int>((bits >> 23U) & 0xffU);
  const double size = exponent == 0 ? 0 : std::ldexp(1 + (bits & 0x7fffffU) / 8388608.0, exponent - 127);
  return (bits >> 31U) != 0 ? -size : size;
}

std::string element_text(const ValueFormat& format_, std::span<const std::byte> bytes) {
  switch (format_.kind) {
    case Kind::is_signed:
      return format("%lld", static_cast<long long>(signed_value(bytes)));
    case Kind::is_unsigned:
      return format("%llu", static_cast<unsigned long long>(unsigned_value(bytes)));
    case Kind::floating:
      if (bytes.size() == 4) return format("%.9g", single_value(read_word(bytes.data())));
      return format("%.17g", std::bit_cast<double>(unsigned_value(bytes)));
    default:
      break;
  }
  std::string text;
  for (const std::byte each : bytes) text += format("%02x", std::to_integer<unsigned>(each));
  return text;
}

/// Characters that the longest element may have.
unsigned column_width(const ValueFormat& format_) {
  if (format_.kind == Kind::hexadecimal) return 2 * format_.element;
  if (format_.kind == Kind::floating) return format_.element == 4 ? 15 : 24;
  constexpr unsigned kDigits[] = {4, 6, 11, 20};  // with a sign
  return kDigits[std::countr_zero(format_.element)];
}
}  // namespace

std::span<const ValueFormat> value_formats() {
  return kFormats;
}

const ValueFormat& default_format() {
  return kFormats[0];
}

const ValueFormat* find_format(std::string_view name) {
  for (const ValueFormat& each : kFormats) {
    if (name == each.name) return &each;
  }
  return nullptr;
}

std::string format_elements(const ValueFormat& format_, std::span<const std::byte> bytes) {
  std::string text;
  for (std::size_t at = 0; at + format_.element <= bytes.size(); at += format_.element) {
    const std::string element = element_text(format_, bytes.subspan(at, format_.element));
    text += format("%s%*s", at == 0 ? "" : " ", static_cast<int>(column_width(format_)), element.c_str());
  }
  return text;
}

std::string format_characters(std::span<const std::byte> bytes) {
  std::string text;
  for (const std::byte each : bytes) {
    const auto c = std::to_integer<unsigned char>(each);
    text += c >= 0x20 && c < 0x7f ? static_cast<char>(c) : '.';
  }
  return text;
}

}  // namespace spu_emu::isa
