/// @file
/// Makes tables of what the suite of Bullet's worlds measured.
#include <cstdio>
#include <string>
#include <string_view>

#include "bench/bullet/table/bullet_tables.h"
#include "bench/measured/page_marks.h"
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

Status run(const std::string& file, bool docs) {
  const Result<std::string> json = report::read_text_file(file);
  if (!json) return json.status();
  const Result<MeasuredRows> measured = read_measured_rows(*json);
  if (!measured) return measured.status();
  std::printf("%s\n\n%s\n%s", measured->machine.c_str(), bullet_frames(*measured).c_str(),
              bullet_questions(*measured).c_str());
  return docs ? put_into_page(*measured) : Status{};
}

}  // namespace

int main(int argc, char** argv) {
  std::string file = "out/bullet/bullet.json";
  bool docs = false;
  for (int i = 1; i < argc; ++i) {
    const std::string_view argument = argv[i];
    if (argument == "--docs") {
      docs = true;
    } else if (argument.starts_with("-")) {
      std::fputs(kUsage.data(), argument == "--help" ? stdout : stderr);
      return argument == "--help" ? 0 : 2;
    } else {
      file = argument;
    }
  }
  const Status status = run(file, docs);
  if (status.ok()) return 0;
  std::fprintf(stderr, "bullet-table: %s\n", status.message.c_str());
  return 2;
}
