// The table of variables as text, whole and broken.
#include "isa/debug/variables.h"

#include <gtest/gtest.h>

#include <sstream>

namespace spu_emu::isa {
namespace {

Variables read(const std::string& text) {
  std::istringstream stream(text);
  return read_variable_table(stream);
}

Variables some() {
  Variables variables;
  variables.types.emplace_back();
  VariableType number;
  number.kind = VariableType::Kind::is_signed;
  number.size = 4;
  number.name = "long int";
  variables.types.push_back(number);
  VariableType pair;
  pair.kind = VariableType::Kind::structure;
  pair.size = 8;
  pair.members = {{"first", 0, 1}, {"", 4, 1}};
  variables.types.push_back(pair);
  VariableType colour;
  colour.kind = VariableType::Kind::enumeration;
  colour.size = 4;
  colour.enumerators = {{"red", -1}, {"blue", 7}};
  variables.types.push_back(colour);
  variables.all.push_back({"total", 2, 0, 0x40000, {{VariablePlace::Kind::address, 0x400, 0, 0x40000}}});
  variables.all.push_back(
      {"total",
       1,
       0x100,
       0x200,
       {{VariablePlace::Kind::frame, -16, 0x100, 0x180}, {VariablePlace::Kind::reg, 80, 0x180, 0x1f0}}});
  return variables;
}

TEST(Variables, are_the_same_after_they_were_text) {
  const Variables variables = read("file a.c\n0x00080 3 statement\n" + variable_table_text(some()));
  EXPECT_EQ(variable_table_text(variables), variable_table_text(some()));
  EXPECT_EQ(variables.types[1].name, "long int");
  EXPECT_EQ(variables.types[2].members[1].offset, 4U);
  EXPECT_EQ(variables.types[3].enumerators[0].value, -1);
}

TEST(Variables, of_one_name_the_innermost_counts_and_a_place_holds_for_its_code_alone) {
  const Variables variables = some();
  EXPECT_EQ(variables.find("total", 0x80)->type, 2U);
  const Variable* inner = variables.find("total", 0x100);
  EXPECT_EQ(inner->type, 1U);
  EXPECT_EQ(inner->place_at(0x17c)->value, -16);
  EXPECT_EQ(inner->place_at(0x180)->value, 80);
  EXPECT_EQ(inner->place_at(0x1f0), nullptr);
  EXPECT_EQ(variables.find("total", 0x200)->type, 2U);
  EXPECT_EQ(variables.find("tot", 0x100), nullptr);
  EXPECT_EQ(variables.names_at(0x100), (std::vector<std::string>{"total", "total"}));
}

TEST(Variables, of_a_broken_table_are_what_is_whole_in_it) {
  const Variables variables = read(
      "member 0 0 lost\nplace 0 1 0 0\ntype 99 4 7 1 strange\nmember 4 12 far\nvariable 0 100 44 x\n"
      "place 0 100 9 1\nplace 0\nvariable\n\nnonsense 1 2 3\n");
  ASSERT_EQ(variables.types.size(), 1U);
  EXPECT_EQ(variables.types[0].kind, VariableType::Kind::unknown);
  EXPECT_EQ(variables.types[0].target, 0U);
  EXPECT_EQ(variables.types[0].members[0].type, 0U);
  EXPECT_EQ(variables.find("x", 50)->type, 0U);
  EXPECT_EQ(variables.find("x", 50)->place_at(50), nullptr);
  EXPECT_EQ(read("").types.size(), 1U);
}

}  // namespace
}  // namespace spu_emu::isa
