#include "isa/timing/timed_instruction.h"

#include <algorithm>
#include <initializer_list>
#include <string_view>

#include "isa/encoding/instruction_word.h"
#include "isa/encoding/opcodes.h"

namespace spu_emu::isa {

namespace {

using Kind = TimedInstruction::Kind;

constexpr std::uint8_t field(std::uint32_t word, unsigned first) {
  return static_cast<std::uint8_t>((word >> first) & 0x7fU);
}

std::uint8_t register_of(char letter, std::uint32_t word) {
  switch (letter) {
    case 't':
      return field(word, 0);
    case 'a':
      return field(word, 7);
    case 'b':
      return field(word, 14);
    case 'c':
      return field(word, 21);
    default:
      return TimedInstruction::kNone;
  }
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Register t is written in the assembler but neither read nor written.
bool has_false_target(std::string_view name) {
  return is_one_of(name, {"nop", "heq", "hgt", "hlgt", "heqi", "hgti", "hlgti", "fscrwr", "stopd"});
}

/// The first register is a source: stores, conditions, channel writes, branches to a register's address.
bool only_reads(std::string_view name, Kind kind) {
  if (kind == Kind::write_channel || kind == Kind::hint) return true;
  return name.starts_with("stq") || is_one_of(name, {"brz", "brnz", "brhz", "brhnz", "biz", "binz", "bihz",
                                                     "bihnz", "bi", "iret", "mtspr"});
}

/// Register t is read and written.
bool accumulates(std::string_view name) {
  return is_one_of(
      name, {"iohl", "addx", "cgx", "sfx", "bgx", "mpyhha", "mpyhhau", "dfma", "dfms", "dfnms", "dfnma"});
}

Kind kind_of(const Instruction& instruction) {
  const std::string_view name = instruction.mnemonic;
  if (name.starts_with("hbr")) return Kind::hint;
  if (instruction.unit == Unit::ls) return Kind::memory;
  if (name == "rdch") return Kind::read_channel;
  if (name == "wrch") return Kind::write_channel;
  return instruction.unit == Unit::br && instruction.flow != Flow::none ? Kind::branch : Kind::plain;
}

Stall waiting_for(Unit unit) {
  switch (unit) {
    case Unit::fp6:
    case Unit::fp7:
    case Unit::fpd:
      return Stall::floating;
    case Unit::shuf:
      return Stall::shuffle;
    case Unit::ls:
      return Stall::load;
    case Unit::spr:
      return Stall::channel;
    default:
      return Stall::fixed;
  }
}

std::uint32_t latency_of(const CycleParameters& parameters, Unit unit) {
  switch (unit) {
    case Unit::fx2:
      return parameters.fixed_latency;
    case Unit::fx3:
      return parameters.shift_latency;
    case Unit::fxb:
      return parameters.byte_latency;
    case Unit::fp6:
      return parameters.float_latency;
    case Unit::fp7:
      return parameters.multiply_latency;
    case Unit::fpd:
      return parameters.double_latency;
    case Unit::shuf:
      return parameters.shuffle_latency;
    case Unit::ls:
      return parameters.load_latency;
    case Unit::br:
      return parameters.branch_latency;
    case Unit::spr:
      return parameters.channel_latency;
    default:
      return 0;
  }
}

void add_source(TimedInstruction& timed, std::uint8_t reg) {
  for (std::uint8_t& source : timed.sources) {
    if (source != TimedInstruction::kNone) continue;
    source = reg;
    return;
  }
}

void fill_registers(TimedInstruction& timed, const Instruction& instruction, std::uint32_t word) {
  const std::string_view name = instruction.mnemonic;
  bool first = true;
  for (const char letter : std::string_view(instruction.operands)) {
    const std::uint8_t reg = register_of(letter, word);
    if (reg == TimedInstruction::kNone || (letter == 't' && has_false_target(name))) continue;
    if (first && letter != 'a' && letter != 'b' && !only_reads(name, timed.kind)) {
      timed.target = reg;
      if (accumulates(name)) add_source(timed, reg);
    } else {
      add_source(timed, reg);
    }
    first = false;
  }
}

/// A hint's branch lies at a distance in words, split in two places of the instruction.
std::uint32_t hinted_branch(const Instruction& instruction, std::uint32_t word, std::uint32_t pc) {
  const std::uint32_t high = instruction.format == Format::rr ? (word >> 14U) & 3U : (word >> 23U) & 3U;
  const auto words = static_cast<std::int32_t>(((high << 7U) | (word & 0x7fU)) << 23U) >> 23U;
  return (pc + static_cast<std::uint32_t>(words * 4)) & kCodeMask;
}

void fill_hint(TimedInstruction& timed, const Instruction& instruction, std::uint32_t word,
               std::uint32_t pc) {
  timed.hinted_branch = hinted_branch(instruction, word, pc);
  timed.hint_by_register = instruction.format == Format::rr;
  if (!timed.hint_by_register) {
    timed.hinted_target = static_cast<std::uint32_t>(immediate_of(instruction, word, pc));
  }
}

}  // namespace

TimedInstruction time_instruction(const CycleParameters& parameters, std::uint32_t word, std::uint32_t pc) {
  TimedInstruction timed;
  timed.word = word;
  timed.known = true;
  const int number = find_instruction(word);
  if (number < 0) return timed;
  const Instruction& instruction = instructions()[static_cast<std::size_t>(number)];
  timed.kind = kind_of(instruction);
  timed.even = is_even_pipe(instruction.unit);
  timed.latency = latency_of(parameters, instruction.unit);
  timed.pauses_issue = instruction.unit == Unit::fpd;
  timed.waiting = waiting_for(instruction.unit);
  fill_registers(timed, instruction, word);
  if (instruction.unit == Unit::spr) {
    timed.channel = static_cast<std::uint32_t>(immediate_of(instruction, word, pc)) & 0x7fU;
  }
  if (timed.kind == Kind::hint) fill_hint(timed, instruction, word, pc);
  return timed;
}

}  // namespace spu_emu::isa
