// Quadwords as elements of any width and kind.
#include "isa/debug/value_format.h"

#include <gtest/gtest.h>

#include <array>

#include "isa/encoding/big_endian.h"

namespace spu_emu::isa {
namespace {

using Words = std::array<std::uint32_t, 4>;

std::string text(const char* name, const Words& words) {
  std::array<std::byte, 16> bytes{};
  for (unsigned i = 0; i < 4; ++i) write_word(bytes.data() + 4 * i, words[i]);
  const ValueFormat* found = find_format(name);
  EXPECT_NE(found, nullptr) << name;
  if (found == nullptr) return {};
  // Columns are wide; the values are what is looked at here.
  std::string all = format_elements(*found, bytes);
  for (std::size_t at = all.find("  "); at != std::string::npos; at = all.find("  ")) all.erase(at, 1);
  return all.substr(all.find_first_not_of(' '));
}

constexpr Words kBytes{0x00017f80, 0xfffffffe, 0x80000000, 0x40490fdb};

TEST(ValueFormat, shows_hexadecimal_elements_of_every_width) {
  EXPECT_EQ(text("x4", kBytes), "00017f80 fffffffe 80000000 40490fdb");
  EXPECT_EQ(text("x1", kBytes), "00017f80fffffffe8000000040490fdb");
  EXPECT_EQ(text("x2", kBytes), "00017f80fffffffe 8000000040490fdb");
  EXPECT_EQ(text("x8", kBytes), "0001 7f80 ffff fffe 8000 0000 4049 0fdb");
  EXPECT_EQ(text("x16", kBytes), "00 01 7f 80 ff ff ff fe 80 00 00 00 40 49 0f db");
}

TEST(ValueFormat, shows_signed_and_unsigned_numbers) {
  EXPECT_EQ(text("char16", kBytes), "0 1 127 -128 -1 -1 -1 -2 -128 0 0 0 64 73 15 -37");
  EXPECT_EQ(text("uchar16", kBytes), "0 1 127 128 255 255 255 254 128 0 0 0 64 73 15 219");
  EXPECT_EQ(text("short8", kBytes), "1 32640 -1 -2 -32768 0 16457 4059");
  EXPECT_EQ(text("ushort8", kBytes), "1 32640 65535 65534 32768 0 16457 4059");
  EXPECT_EQ(text("int4", kBytes), "98176 -2 -2147483648 1078530011");
  EXPECT_EQ(text("uint4", kBytes), "98176 4294967294 2147483648 1078530011");
  EXPECT_EQ(text("llong2", {0xffffffff, 0xffffffff, 0, 7}), "-1 7");
  EXPECT_EQ(text("ullong2", {0xffffffff, 0xffffffff, 0, 7}), "18446744073709551615 7");
}

TEST(ValueFormat, shows_single_precision_as_an_spu_has_it) {
  EXPECT_EQ(text("float4", {0x3f800000, 0xc0490fdb, 0x00000001, 0x80000000}), "1 -3.14159274 0 -0");
  // What other machines take for infinity and NaN are numbers.
  EXPECT_EQ(text("float4", {0x7f800000, 0x7fffffff, 0xffc00000, 0}),
            "3.40282367e+38 6.80564693e+38 -5.1042355e+38 0");
}

TEST(ValueFormat, shows_double_precision) {
  EXPECT_EQ(text("double2", {0x3ff80000, 0, 0xc0590000, 0}), "1.5 -100");
}

TEST(ValueFormat, knows_no_other_names) {
  EXPECT_EQ(find_format("float"), nullptr);
  EXPECT_EQ(find_format(""), nullptr);
}

TEST(ValueFormat, has_points_for_what_cannot_be_printed) {
  const std::array<std::byte, 4> bytes{std::byte{'O'}, std::byte{'k'}, std::byte{0}, std::byte{0xff}};
  EXPECT_EQ(format_characters(bytes), "Ok..");
}

}  // namespace
}  // namespace spu_emu::isa
