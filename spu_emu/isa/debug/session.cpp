#include "isa/debug/session.h"

#include <algorithm>

#include "isa/encoding/disassembler.h"
#include "isa/encoding/instruction_word.h"
#include "mfc/format.h"

namespace spu_emu::isa {

std::uint32_t Session::word(std::uint32_t address) const {
  return fetch(store, address);
}

std::string Session::source_text(const LineRow& row) const {
  const auto text = read_source(map.lines().file(row.file), row.line, row.line);
  return format("%-6u %s\n", row.line,
                text.empty() ? "(its file is not there to be read)" : text.front().c_str());
}

std::string Session::standing() const {
  const std::uint32_t pc = machine.pc();
  std::string instruction = disassemble(word(pc), pc);
  std::replace(instruction.begin(), instruction.end(), '\t', ' ');
  std::string text = "  at pc " + map.place(pc) + ": " + instruction + "\n";
  if (const auto row = map.lines().at(pc)) text += source_text(*row);
  return text;
}

}  // namespace spu_emu::isa
