/// @file
/// Options from texts: what is a value of which kind, and the sentences that refuse the others.
#include "base/settings.h"

#include <gmock/gmock.h>

#include <array>
#include <cstdint>
#include <limits>

namespace cellsweep {
namespace {

using testing::AllOf;
using testing::HasSubstr;

enum class Colour { red, green };

struct Options {
  bool loud = false;
  unsigned threads = 3;
  std::uint64_t bytes = 10;
  Colour colour = Colour::red;
  std::string name = "nobody";
  float width = 0.5F;
};

constexpr std::array<std::pair<std::string_view, Colour>, 2> kColours = {
    {{"red", Colour::red}, {"green", Colour::green}}};

const std::vector<SettingRow<Options>> kRows = {
    {{"loud", SettingKind::flag, "false", "whether it is loud"},
     [](Options& options, std::string_view value) { return read_flag(options.loud, value); }},
    {{"threads", SettingKind::number, "3", "how many"},
     [](Options& options, std::string_view value) { return read_number(options.threads, value); }},
    {{"bytes", SettingKind::bytes, "10", "how much"},
     [](Options& options, std::string_view value) { return read_number(options.bytes, value); }},
    {{"colour", SettingKind::choice, "red", "of what", {"red", "green"}},
     [](Options& options, std::string_view value) {
       return read_choice<Colour>(options.colour, value, kColours);
     }},
    {{"width", SettingKind::length, "0.5", "how wide"},
     [](Options& options, std::string_view value) { return read_length(options.width, value); }},
    {{"name", SettingKind::text, "nobody", "of whom"},
     [](Options& options, std::string_view value) { return read_text(options.name, value); }},
};

Result<Options> read(const SettingValues& values) {
  return read_settings<Options>("test", values, kRows);
}

TEST(Settings, ThatAreNotGivenStayWhatTheyAre) {
  const auto options = read({});
  ASSERT_TRUE(options.ok());
  EXPECT_EQ(options->threads, 3U);
  EXPECT_EQ(options->name, "nobody");
}

TEST(Settings, AreLengthsWhenTheyAreFiniteAndNotNegative) {
  for (const auto& [value, width] : {std::pair{"0.25", 0.25F}, {"3", 3.0F}, {"1e-3", 1e-3F}, {"0", 0.0F}}) {
    const auto options = read({{"width", value}});
    ASSERT_TRUE(options.ok()) << value;
    EXPECT_EQ(options->width, width);
  }
  for (const char* value : {"-1", "-1e-9", "nan", "inf", "1e99", "", "1m", " 1", "0x1"}) {
    const Status status = read({{"width", value}}).status();
    EXPECT_EQ(status.setting, "width") << value;
    EXPECT_THAT(status.message, AllOf(HasSubstr(value), HasSubstr("a length, 0 or more")));
  }
}

TEST(Settings, AreReadFromTheirTexts) {
  const auto options = read(
      {{"threads", "12"}, {"loud", "true"}, {"colour", "green"}, {"bytes", "8589934592"}, {"name", "a b"}});
  ASSERT_TRUE(options.ok()) << options.status().message;
  EXPECT_EQ(options->threads, 12U);
  EXPECT_TRUE(options->loud);
  EXPECT_EQ(options->colour, Colour::green);
  EXPECT_EQ(options->bytes, 8'589'934'592U);
  EXPECT_EQ(options->name, "a b");
}

TEST(Settings, GivenTwiceAreWhatTheyAreGivenLast) {
  const auto options = read({{"loud", "true"}, {"threads", "1"}, {"loud", "false"}, {"threads", "2"}});
  ASSERT_TRUE(options.ok());
  EXPECT_FALSE(options->loud);
  EXPECT_EQ(options->threads, 2U);
}

TEST(Settings, OfNoValueOfTheirKindAreRefusedWithWhatItWouldBe) {
  struct Case {
    const char* name;
    const char* value;
    const char* wanted;
  };
  const Case cases[] = {{"loud", "yes", "true or false"},       {"loud", "", "true or false"},
                        {"threads", "-1", "a whole number"},    {"threads", "1.5", "a whole number"},
                        {"bytes", "1 KB", "a number of bytes"}, {"colour", "blue", "red, green"},
                        {"colour", "re", "red, green"}};
  for (const auto& [name, value, wanted] : cases) {
    const Status status = read({{"threads", "1"}, {name, value}}).status();
    EXPECT_EQ(status.code, StatusCode::bad_option) << name << " = " << value;
    EXPECT_EQ(status.setting, name);
    EXPECT_THAT(status.message,
                AllOf(HasSubstr(name), HasSubstr('"' + std::string(value) + '"'), HasSubstr(wanted)));
  }
}

TEST(Settings, ThatThereAreNotAreRefusedWithThoseThatThereAre) {
  const Status status = read({{"thread", "1"}}).status();
  EXPECT_EQ(status.code, StatusCode::bad_option);
  EXPECT_EQ(status.setting, "thread");
  EXPECT_THAT(status.message,
              AllOf(HasSubstr("Engine test"), HasSubstr("loud, threads, bytes, colour, width, name")));
  const Status none = read_settings<Options>("plain", {{"x", ""}}, {}).status();
  EXPECT_THAT(none.message, AllOf(HasSubstr("Engine plain"), HasSubstr("it has: none")));
}

TEST(Settings, DescribeThemselves) {
  const std::vector<SettingInfo> infos = describe_settings<Options>(kRows);
  ASSERT_EQ(infos.size(), kRows.size());
  for (std::size_t i = 0; i < infos.size(); ++i) EXPECT_EQ(infos[i].name, kRows[i].info.name);
  EXPECT_THAT(infos[3].choices, testing::ElementsAre("red", "green"));
}

TEST(ReadNumber, TakesWhatFitsAndNothingElse) {
  std::uint32_t number = 7;
  for (const char* text :
       {"", " 1", "1 ", "+1", "-1", "0x1", "1e3", "4294967296", "99999999999999999999", "one"}) {
    EXPECT_FALSE(read_number(number, text)) << text;
    EXPECT_EQ(number, 7U) << "a refused text changes nothing";
  }
  EXPECT_TRUE(read_number(number, "4294967295"));
  EXPECT_EQ(number, std::numeric_limits<std::uint32_t>::max());
  EXPECT_TRUE(read_number(number, "0"));
  EXPECT_EQ(number, 0U);
}

}  // namespace
}  // namespace cellsweep
