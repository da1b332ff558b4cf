/// @file
/// Names for addresses of a program, and addresses for names: symbols, source lines, numbers, registers.
#ifndef SPU_EMU_ISA_DEBUG_CODE_MAP_H
#define SPU_EMU_ISA_DEBUG_CODE_MAP_H

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "isa/core/machine.h"
#include "isa/debug/source_lines.h"
#include "isa/elf/elf_loader.h"

namespace spu_emu::isa {

/// A command that cannot be done, and why, in a sentence for who typed it.
struct CommandError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class CodeMap {
 public:
  /// `symbols` by rising address. Names of C++ functions are shown, and may be typed, without their
  /// parameters.
  CodeMap(std::vector<ElfSymbol> symbols, SourceLines lines);

  const SourceLines& lines() const { return lines_; }
  const std::vector<ElfSymbol>& symbols() const { return symbols_; }

  /// The symbol that `address` lies in, or the last one before it; null if there is none.
  const ElfSymbol* symbol_at(std::uint32_t address) const;
  /// "0x00124 in main+0x24 (pi.cpp:10)", as much of it as is known.
  std::string place(std::uint32_t address) const;
  /// "main+0x24", or nothing.
  std::string symbol_text(std::uint32_t address) const;
  /// "pi.cpp:10", or nothing.
  std::string line_text(std::uint32_t address) const;

  /// An address or a size: a number, a symbol, $7 (the first word of a register) or pc; sums and differences
  /// of them. Throws CommandError.
  std::uint32_t value(std::string_view text, const Machine& machine) const;
  /// Where code is: FILE:LINE, LINE (of the file that the program stands in), or what `value` takes, a *
  /// before it or not. Throws CommandError, also for what is no instruction of the local store.
  std::vector<std::uint32_t> code(std::string_view text, const Machine& machine) const;

 private:
  std::uint32_t term(std::string_view text, const Machine& machine) const;
  std::vector<std::uint32_t> symbol_addresses(std::string_view name) const;
  std::uint32_t symbol_address(std::string_view name) const;
  std::vector<std::uint32_t> line_code(std::string_view file, std::string_view line,
                                       const Machine& machine) const;
  std::uint32_t one_file(std::string_view name, const Machine& machine) const;

  std::vector<ElfSymbol> symbols_;
  SourceLines lines_;
};

/// A decimal number or a hexadecimal one after 0x. Throws CommandError.
std::uint32_t number_in(std::string_view text);

/// Throws CommandError unless `address` is that of an instruction word / these bytes lie in the local store.
void check_code_address(std::uint32_t address);
void check_bytes(std::uint32_t first, std::uint64_t size);

/// The name of `names` that is nearest to `text`, or nothing if none is near.
std::string nearest_name(std::string_view text, const std::vector<std::string>& names);

}  // namespace spu_emu::isa

#endif
