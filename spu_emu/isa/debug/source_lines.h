/// @file
/// Which line of source an instruction comes from, and where the code of a line is.
#ifndef SPU_EMU_ISA_DEBUG_SOURCE_LINES_H
#define SPU_EMU_ISA_DEBUG_SOURCE_LINES_H

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace spu_emu::isa {

/// From `address` on instructions come from this line, up to the next row.
struct LineRow {
  std::uint32_t address = 0;
  std::uint32_t file = 0;  // a place in the table's files
  std::uint32_t line = 0;  // 0: no line
  bool statement = false;  // a good place to stop
  bool end = false;        // here nothing more is known
};

/// The code of a line: the first instructions of it, by rising address.
struct LineCode {
  std::uint32_t file = 0;
  std::uint32_t line = 0;
  std::vector<std::uint32_t> addresses;
};

class SourceLines {
 public:
  SourceLines() = default;
  SourceLines(std::vector<std::string> files, std::vector<LineRow> rows);

  const std::vector<LineRow>& rows() const { return rows_; }
  bool empty() const { return rows_.empty(); }
  const std::string& file(std::uint32_t number) const { return files_[number]; }

  /// The row of an instruction, if a line is known for it.
  std::optional<LineRow> at(std::uint32_t address) const;
  /// Whether a statement begins with exactly this instruction.
  bool begins_statement(std::uint32_t address) const;

  /// Files whose path ends in `name`, whole names of folders: "a.c" is "src/a.c", and not "ba.c".
  std::vector<std::uint32_t> files_named(std::string_view name) const;
  /// The code of `line`, or of the first line behind it that has some.
  std::optional<LineCode> code_of(std::uint32_t file, std::uint32_t line) const;
  /// The last line of the file that has code; 0 if none has.
  std::uint32_t last_line(std::uint32_t file) const;

 private:
  std::vector<std::string> files_;
  std::vector<LineRow> rows_;
};

/// The last part of a path.
std::string file_name(std::string_view path);

/// The text of lines `first` to `last` of a file of this machine, as far as it has them; none if it cannot be
/// read.
std::vector<std::string> read_source(const std::string& path, std::uint32_t first, std::uint32_t last);

}  // namespace spu_emu::isa

#endif
