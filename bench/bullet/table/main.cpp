/// @file
/// Makes tables of what the suite of Bullet's worlds measured.
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "bench/bullet/table/bullet_tables.h"
#include "bench/measured/page_marks.h"
#include "bench/measured/table_program.h"
#include "report/text_file.h"

namespace {

using namespace cellsweep;
using namespace cellsweep::bench;

constexpr std::string_view kUsage =
    "usage: bullet-table [--docs] [FILE.json]\n"
    "Reads what ./run bench bullet measured (out/bullet/bullet.json, unless a file is named), and prints\n"
    "tables of steps and of questions.\n"
    "  --docs   also puts them into docs/bullet.md\n";

Status put_into_page(const MeasuredRows& measured) {
  constexpr const char* kPage = "docs/bullet.md";
  Result<std::string> text = report::read_text_file(kPage);
  if (text) text = replace_between_marks(*text, "bullet", bullet_frames(measured));
  if (text) text = replace_between_marks(*text, "bullet-questions", bullet_questions(measured));
  return text ? report::write_text_file(kPage, *text) : text.status();
}

Status run(const std::vector<std::string>& files, bool docs) {
  if (files.size() > 1)
    return Status::bad_input("One file is read, not " + std::to_string(files.size()) + ".");
  const Result<std::string> json = report::read_text_file(files.front());
  if (!json) return json.status();
  const Result<MeasuredRows> measured = read_measured_rows(*json);
  if (!measured) return measured.status();
  std::printf("%s\n\n%s\n%s", measured->machine.c_str(), bullet_frames(*measured).c_str(),
              bullet_questions(*measured).c_str());
  return docs ? put_into_page(*measured) : Status{};
}

}  // namespace

int main(int argc, char** argv) {
  return run_table_program({"bullet-table", kUsage, "out/bullet/bullet.json", run}, argc, argv);
}
