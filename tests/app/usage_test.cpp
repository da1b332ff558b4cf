#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

#include "command_line.h"
#include "report/build_context.h"

namespace cellsweep::app {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr std::size_t kColumns = 80;

const std::vector<std::string>& commands() {
  static const std::vector<std::string> names = {"simulate", "replay",      "record",     "verify",
                                                 "engines",  "local-store", "experiment", "render",
                                                 "view",     "query",       "demo"};
  return names;
}

/// Characters of UTF-8.
std::size_t width_of(const std::string& line) {
  return static_cast<std::size_t>(std::count_if(
      line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

void expect_to_fit(const std::string& help, const std::string& name) {
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(width_of(line), kColumns) << name << ": " << line;
}

TEST(Usage, HasExamplesAndExitCodes) {
  const CommandResult result = run_command("--help");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, HasSubstr("Examples:"));
  EXPECT_THAT(result.output, HasSubstr("Exit codes: 0 good, 1 results differ"));
  EXPECT_THAT(result.output, HasSubstr("130 stopped by Ctrl-C"));
  EXPECT_THAT(result.output, HasSubstr("6 output was lost, 7 no more memory"));
  expect_to_fit(result.output, "cellsweep");
}

TEST(Usage, NamesEveryCommandAndGivesItAHelpPageOfEightyColumns) {
  const CommandResult all = run_command("--help");
  for (const std::string& name : commands()) {
    EXPECT_THAT(all.output, HasSubstr("\n  " + name + " "));
    const CommandResult result = run_command(name + " --help");
    EXPECT_EQ(result.exit_code, 0) << name;
    EXPECT_THAT(result.output, HasSubstr("--help")) << name;
    EXPECT_THAT(result.output, Not(HasSubstr("\n\n\n"))) << name;
    EXPECT_THAT(result.errors, IsEmpty()) << name;
    expect_to_fit(result.output, name);
  }
}

TEST(Usage, IsThatOfEveryCommandThereIs) {
  const CommandResult all = run_command("--help");
  const std::size_t begin = all.output.find("Subcommands:\n");
  const std::size_t end = all.output.find("\nExamples:");
  std::istringstream lines(all.output.substr(begin, end - begin));
  std::size_t entries = 0;
  for (std::string line; std::getline(lines, line);)
    entries += line.size() > 2 && line[0] == ' ' && line[2] != ' ';
  EXPECT_EQ(entries, commands().size());
}

TEST(Usage, HasAVersionWithTheCommit) {
  const CommandResult result = run_command("--version");
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.output, report::version_text() + "\n");
  EXPECT_THAT(result.output, testing::MatchesRegex("cellsweep [0-9]+\\.[0-9]+\\.[0-9]+, commit .+\n"));
}

}  // namespace
}  // namespace cellsweep::app
