// printf and scanf of SPU programs: formats, arguments in registers and on the stack, formats that lie.
#include "isa/libc/print_format.h"

#include <gtest/gtest.h>

#include <cerrno>

#include "call_store.h"
#include "isa/libc/scan_format.h"

namespace spu_emu::isa {
namespace {

constexpr std::uint32_t kVaList = 0x300;

struct Formatted : CallStore {
  Formatted() {
    store.set_word(kVaList, kArguments);
    store.set_word(kVaList + 16, kArgumentsEnd);
  }
  std::string print(const std::string& format) {
    ArgumentList arguments(store, kVaList);
    const PrintResult result = print_format(store, format, arguments);
    return result.error == 0 ? result.text : result.error == EOVERFLOW ? "too long" : "no character";
  }
  int scan(const std::string& input, const std::string& format) {
    ArgumentList arguments(store, kVaList);
    TextSource source(input);
    return scan_format(store, source, format, arguments);
  }
};

TEST(PrintFormat, prints_integers_of_every_length) {
  Formatted f;
  for (const std::uint32_t word : {0xffffffffU, 0xffffffffU, 0x1ffffU, 0x1ffU, 0x41U}) f.add_word(word);
  f.add_doubleword(0x123456789abcdef0U);
  f.add_doubleword(static_cast<std::uint64_t>(-5));
  EXPECT_EQ(f.print("%d %u %hd %hhu %c %llx %lld"), "-1 4294967295 -1 255 A 123456789abcdef0 -5");
}

TEST(PrintFormat, obeys_flags_width_and_precision) {
  Formatted f;
  for (const std::uint32_t word : {42U, 42U, 42U, 255U, 8U, 42U, 6U, 3U, 42U, 0xfffffffbU, 42U})
    f.add_word(word);
  EXPECT_EQ(f.print("[%5d|%-5d|%05d|%#x|%#o|%+.3d|%*.*d|%*d]"),
            "[   42|42   |00042|0xff|010|+042|   042|42   ]");
}

TEST(PrintFormat, prints_doubles_texts_pointers_and_percent) {
  Formatted f;
  f.add_double(3.25);
  f.add_double(-1e100);
  f.add_double(0.5);
  f.add_word(f.text("world"));
  f.add_word(f.text("world"));
  f.add_word(f.text("ab"));
  f.add_word(0x1234);
  f.add_word(0);
  EXPECT_EQ(f.print("%f %g %10.1e|%s %.2s %-4s|%p %s %% %k"),
            "3.250000 -1e+100    5.0e-01|world wo ab  |0x1234 (null) % %k");
}

TEST(PrintFormat, arguments_beyond_the_registers_come_from_the_callers_frame) {
  Formatted f;
  f.store.set_word(kVaList, CallStore::kArgumentsEnd - 16);
  f.store.set_word(CallStore::kArgumentsEnd - 16, 1);
  f.store.set_word(CallStore::kArgumentsEnd, 0xbad);
  f.store.set_word(CallStore::kArgumentsEnd + 32, 2);
  f.store.set_word(CallStore::kArgumentsEnd + 48, 3);
  EXPECT_EQ(f.print("%d %d %d"), "1 2 3");
}

TEST(PrintFormat, n_stores_the_count) {
  Formatted f;
  f.add_word(0x600);
  EXPECT_EQ(f.print("four%n"), "four");
  EXPECT_EQ(f.store.word(0x600), 4U);
}

TEST(PrintFormat, lies_are_bad_addresses_or_cut_down) {
  Formatted text;
  text.add_word(0x50000);
  EXPECT_THROW(text.print("%s"), BadAddress);
  Formatted unended;
  std::fill(unended.bytes.end() - 64, unended.bytes.end(), std::byte{'x'});
  unended.add_word(kStoreSize - 8);
  EXPECT_THROW(unended.print("%s"), BadAddress);
  EXPECT_EQ(unended.print("%.8s"), "xxxxxxxx");
  Formatted count;
  count.add_word(0xfffffffe);
  EXPECT_THROW(count.print("%n"), BadAddress);
  Formatted arguments;
  arguments.store.set_word(kVaList, 0xfffffff8);
  EXPECT_THROW(arguments.print("%d"), BadAddress);
  Formatted wide;
  wide.add_word(1);
  EXPECT_EQ(wide.print("%999999999999d").size(), 4096U);
  EXPECT_EQ(wide.print("%"), "%");
  EXPECT_EQ(wide.print("%-08"), "%-08");
}

TEST(PrintFormat, an_output_without_end_is_refused) {
  Formatted f;
  f.add_word(1);
  std::string format;
  for (int i = 0; i < 5000; ++i) format += "%4096%%4096c";
  EXPECT_EQ(f.print(format).substr(0, 3), "too");
}

TEST(ScanFormat, reads_numbers_words_and_sets) {
  Formatted f;
  for (std::uint32_t at = 0x400; at < 0x470; at += 16) f.add_word(at);
  EXPECT_EQ(f.scan("12 -0x1f 3.5 2.25 word abcZ9 7", "%d %i %f %lf %7s %[a-z]Z%llu"), 7);
  EXPECT_EQ(f.store.word(0x400), 12U);
  EXPECT_EQ(f.store.word(0x410), static_cast<std::uint32_t>(-31));
  EXPECT_EQ(f.store.word(0x420), 0x40600000U);
  EXPECT_EQ(f.store.doubleword(0x430), 0x4002000000000000U);
  EXPECT_EQ(f.store.text(0x440), "word");
  EXPECT_EQ(f.store.text(0x450), "abc");
  EXPECT_EQ(f.store.doubleword(0x460), 9U);
}

TEST(ScanFormat, tells_where_it_stopped) {
  Formatted f;
  f.add_word(0x400);
  f.add_word(0x410);
  EXPECT_EQ(f.scan("", "%d"), EOF);
  EXPECT_EQ(f.scan("x", "%d"), 0);
  EXPECT_EQ(f.scan("1 x", "%d %d"), 1);
  EXPECT_EQ(f.scan("12345", "%2d%n"), 1);
  EXPECT_EQ(f.store.word(0x400), 12U);
  EXPECT_EQ(f.store.word(0x410), 2U);
  EXPECT_EQ(f.scan("5 6", "%*d %hd"), 1);
  Formatted wild;
  wild.add_word(0x3fffe);
  EXPECT_THROW(wild.scan("1", "%d"), BadAddress);
}

/// The address of a wide text.
std::uint32_t wide(Formatted& f, const std::u32string& text, std::uint32_t at) {
  for (std::size_t i = 0; i <= text.size(); ++i) {
    f.store.set_word(at + static_cast<std::uint32_t>(4 * i), i < text.size() ? text[i] : 0);
  }
  return at;
}

TEST(PrintFormat, wide_characters_are_words_and_become_utf_8) {
  Formatted f;
  f.add_word(wide(f, U"wide", 0x2000));
  f.add_word(U'x');
  f.add_word(0x20ac);
  f.add_word(wide(f, U"a\u00e9\U0001f600", 0x2100));
  f.add_word(0x2100);
  f.add_word(0x2100);
  f.add_word(0);
  EXPECT_EQ(f.print("%ls|%3lc|%C|%-9ls|%.2ls|%.3S|%ls"),
            "wide|  x|\u20ac|a\u00e9\U0001f600  |a|a\u00e9|(null)");
}

TEST(PrintFormat, a_word_that_is_no_character_ends_the_text) {
  for (const std::uint32_t word : {0xd800U, 0x110000U, 0xffffffffU}) {
    Formatted f;
    f.add_word(word);
    EXPECT_EQ(f.print("a%lcb"), "no character");
  }
}

TEST(ScanFormat, wide_characters_come_from_utf_8) {
  Formatted f;
  for (const std::uint32_t address : {0x2000U, 0x2100U, 0x2200U, 0x2300U}) f.add_word(address);
  EXPECT_EQ(f.scan("h\u00e9 \u20acxyz 7", "%ls %lc%2l[xy]%S"), 4);
  EXPECT_EQ(f.store.word(0x2004), 0xe9U);
  EXPECT_EQ(f.store.word(0x2008), 0U);
  EXPECT_EQ(f.store.word(0x2100), 0x20acU);
  EXPECT_EQ(f.store.word(0x2204), std::uint32_t{'y'});
  EXPECT_EQ(f.store.word(0x2300), std::uint32_t{'z'});
  Formatted broken;
  broken.add_word(0x2000);
  EXPECT_EQ(broken.scan("\xc3(", "%ls"), 0);
}

}  // namespace
}  // namespace spu_emu::isa
