/// @file
/// Where a debugger reads commands and writes what it has to say.
#ifndef SPU_EMU_ISA_DEBUG_CONSOLE_H
#define SPU_EMU_ISA_DEBUG_CONSOLE_H

#include <cstdio>
#include <memory>
#include <optional>
#include <string>

namespace spu_emu::isa {

/// Commands come from a file or from standard input; all text goes to standard error, so that standard output
/// is the program's. Commands that nobody types are written behind the prompt, so that the text reads like a
/// session.
class Console {
 public:
  /// `file` empty: standard input. Throws std::runtime_error, with the reason, when the file cannot be read.
  explicit Console(const std::string& file);

  /// Whether somebody types.
  bool is_terminal() const { return terminal_; }
  /// The next line, without blanks around it; nothing at the end. Of a file, not empty lines and those that
  /// begin with #.
  std::optional<std::string> read(const std::string& prompt);
  /// Writes whole lines, after what the program has printed.
  void write(const std::string& lines);

  /// How many commands of a file are left; 0 of standard input.
  unsigned count_rest();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  std::optional<std::string> read_line();

  std::unique_ptr<std::FILE, Closer> file_;
  bool terminal_ = false;
};

}  // namespace spu_emu::isa

#endif
