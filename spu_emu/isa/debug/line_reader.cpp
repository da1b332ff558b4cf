#include "isa/debug/line_reader.h"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>

#include "isa/debug/line_table_text.h"

namespace spu_emu::isa {

namespace {

/// A file of its own with these bytes, as long as the object lives; no name when it could not be written.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::span<const std::byte> bytes) {
    const int file = mkstemp(name_.data());
    if (file < 0) {
      name_.clear();
      return;
    }
    const std::unique_ptr<std::FILE, decltype(&std::fclose)> stream(fdopen(file, "wb"), &std::fclose);
    std::fwrite(bytes.data(), 1, bytes.size(), stream.get());
  }
  ~TemporaryFile() {
    if (!name_.empty()) unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  const std::string& name() const { return name_; }

 private:
  std::string name_ = "/tmp/spu_emu_lines.XXXXXX";
};

std::string output_of(const std::string& command) {
  const std::unique_ptr<std::FILE, decltype(&pclose)> pipe(popen(command.c_str(), "r"), &pclose);
  std::string output;
  char part[4096];
  while (pipe) {
    const std::size_t got = std::fread(part, 1, sizeof part, pipe.get());
    if (got == 0) break;
    output.append(part, got);
  }
  return output;
}

}  // namespace

DwarfLines read_lines(std::span<const std::byte> elf_file) {
  DwarfLines here = read_dwarf_lines(elf_file);
  const char* reader = std::getenv("SPU_EMU_LINE_READER");
  if (here.missing.empty() || reader == nullptr || *reader == '\0') return here;
  const TemporaryFile file(elf_file);
  const std::string text = output_of(std::string(reader) + " " + file.name());
  std::istringstream table(text);
  std::istringstream again(text);
  SourceLines lines = read_line_table(table);
  if (!lines.empty()) return {std::move(lines), read_variable_table(again), {}};
  return here;
}

}  // namespace spu_emu::isa
