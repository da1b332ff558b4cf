#include "isa/debug/console.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace spu_emu::isa {

namespace {
std::string without_blanks(const std::string& text) {
  constexpr const char* kBlanks = " \t\r";
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) + 1 - first);
}
}  // namespace

Console::Console(const std::string& file) : terminal_(file.empty() && isatty(STDIN_FILENO) == 1) {
  if (file.empty()) return;
  file_.reset(std::fopen(file.c_str(), "r"));
  // A folder can be opened, and not read.
  if (file_) {
    std::ungetc(std::fgetc(file_.get()), file_.get());
    if (std::ferror(file_.get()) == 0) return;
  }
  throw std::runtime_error("the debugger's commands, " + file + ": " + std::strerror(errno));
}

std::optional<std::string> Console::read_line() {
  std::FILE* from = file_ ? file_.get() : stdin;
  std::string line;
  int c = std::fgetc(from);
  if (c == EOF) return std::nullopt;
  for (; c != EOF && c != '\n'; c = std::fgetc(from)) line += static_cast<char>(c);
  return without_blanks(line);
}

std::optional<std::string> Console::read(const std::string& prompt) {
  if (terminal_) write(prompt);
  auto line = read_line();
  while (!terminal_ && line && (line->empty() || line->front() == '#')) line = read_line();
  if (!terminal_ && line) write(prompt + *line + "\n");
  if (terminal_ && !line) write("\n");
  return line;
}

void Console::write(const std::string& lines) {
  std::fflush(stdout);
  std::fputs(lines.c_str(), stderr);
}

unsigned Console::count_rest() {
  unsigned count = 0;
  while (file_) {
    const auto line = read_line();
    if (!line) break;
    if (!line->empty() && line->front() != '#') ++count;
  }
  return count;
}

}  // namespace spu_emu::isa
