// Lines for instructions and instructions for lines, and the table as text.
#include "isa/debug/source_lines.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "isa/debug/line_table_text.h"

namespace spu_emu::isa {
namespace {

using Addresses = std::vector<std::uint32_t>;

/// Two pieces of code that meet at 0x20, the second given first; a hole behind them.
SourceLines table() {
  return {{"/src/work/b.c", "/src/a.c"},
          {{0x20, 1, 7, true, false},
           {0x28, 1, 8, true, false},
           {0x30, 1, 8, true, true},
           {0x10, 0, 3, true, false},
           {0x14, 0, 4, false, false},
           {0x18, 0, 3, true, false},
           {0x20, 0, 3, true, true}}};
}

TEST(SourceLines, know_the_line_of_an_instruction) {
  const SourceLines lines = table();
  EXPECT_EQ(lines.at(0x10)->line, 3U);
  EXPECT_EQ(lines.at(0x14)->line, 4U);
  EXPECT_EQ(lines.at(0x1c)->line, 3U);
  EXPECT_EQ(lines.at(0x20)->line, 7U);
  EXPECT_EQ(lines.file(lines.at(0x24)->file), "/src/a.c");
  EXPECT_FALSE(lines.at(0x0c));
  EXPECT_FALSE(lines.at(0x30));
}

TEST(SourceLines, know_where_statements_begin) {
  const SourceLines lines = table();
  EXPECT_TRUE(lines.begins_statement(0x18));
  EXPECT_FALSE(lines.begins_statement(0x14));
  EXPECT_FALSE(lines.begins_statement(0x1c));
  EXPECT_FALSE(lines.begins_statement(0x30));
}

TEST(SourceLines, prefer_of_several_rows_of_an_instruction_the_last_that_begins_a_statement) {
  const SourceLines lines({"a.c"}, {{0x10, 0, 1, true, false},
                                    {0x10, 0, 2, true, false},
                                    {0x10, 0, 3, false, false},
                                    {0x14, 0, 4, false, false},
                                    {0x14, 0, 5, false, false},
                                    {0x18, 0, 5, true, true}});
  EXPECT_EQ(lines.at(0x10)->line, 2U);
  EXPECT_TRUE(lines.begins_statement(0x10));
  EXPECT_EQ(lines.at(0x14)->line, 5U);
  EXPECT_FALSE(lines.at(0x18));
}

TEST(SourceLines, find_files_by_the_end_of_their_path) {
  const SourceLines lines = table();
  EXPECT_EQ(lines.files_named("b.c"), Addresses{0});
  EXPECT_EQ(lines.files_named("work/b.c"), Addresses{0});
  EXPECT_TRUE(lines.files_named("ork/b.c").empty());
}

TEST(SourceLines, find_the_code_of_a_line_or_of_the_next_that_has_some) {
  const SourceLines lines = table();
  EXPECT_EQ(lines.code_of(0, 3)->addresses, (Addresses{0x10, 0x18}));
  EXPECT_EQ(lines.code_of(0, 1)->line, 3U);
  EXPECT_EQ(lines.code_of(1, 8)->addresses, Addresses{0x28});
  EXPECT_FALSE(lines.code_of(0, 5));
  EXPECT_EQ(lines.last_line(0), 4U);
}

TEST(SourceLines, come_back_from_text_as_they_were) {
  const SourceLines lines = table();
  std::istringstream text(line_table_text(lines));
  const SourceLines again = read_line_table(text);
  ASSERT_EQ(again.rows().size(), lines.rows().size());
  for (std::size_t i = 0; i < lines.rows().size(); ++i) {
    EXPECT_EQ(again.rows()[i].address, lines.rows()[i].address);
    EXPECT_EQ(again.rows()[i].line, lines.rows()[i].line);
    EXPECT_EQ(again.rows()[i].statement && !again.rows()[i].end,
              lines.rows()[i].statement && !lines.rows()[i].end);
    EXPECT_EQ(again.rows()[i].end, lines.rows()[i].end);
    EXPECT_EQ(again.file(again.rows()[i].file), lines.file(lines.rows()[i].file));
  }
}

TEST(SourceLines, leave_out_what_is_no_row) {
  std::istringstream text("0x10 3 statement\nfile a.c\nnonsense\n0x20\n0x24 9 statement\n");
  const SourceLines lines = read_line_table(text);
  ASSERT_EQ(lines.rows().size(), 1U);
  EXPECT_EQ(lines.rows().front().line, 9U);
}

TEST(SourceLines, are_read_from_files_as_far_as_these_go) {
  const std::string path = testing::TempDir() + "spu_emu_source_lines.txt";
  std::ofstream(path) << "one\ntwo\nthree\n";
  EXPECT_EQ(read_source(path, 2, 9), (std::vector<std::string>{"two", "three"}));
  EXPECT_TRUE(read_source(path + ".none", 1, 2).empty());
}

}  // namespace
}  // namespace spu_emu::isa
